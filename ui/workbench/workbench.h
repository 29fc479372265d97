// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_id.h"
#include "ui/session/session_controller.h"

#include <functional>
#include <initializer_list>

class QAction;
class QMainWindow;

namespace dewpoint::ui {

class ActionRegistry;
class CameraListModel;
class DockManager;
class Document;
class MessageBar;
class Selection;
class TargetListModel;

/// What views and features are installed into: the parts of the window that all of them share. A
/// feature takes it in its constructor (or in an install function), makes its dock, connects its
/// actions and asks for the snapshots; nothing else of the window knows of it.
struct Workbench {
  QMainWindow& window; ///< parent of docks, views and dialogs
  ActionRegistry& actions;
  Document& document;
  CameraListModel& cameras; ///< of the document, for all lists of cameras
  TargetListModel& targets; ///< the same of targets
  Selection& selection;
  SessionController& session;
  DockManager& docks;
  MessageBar& messages;

  /// The action with this id.
  QAction* action(ActionId id) const;
  void onTriggered(ActionId id, QObject* context, std::function<void()> run) const;
  void onToggled(ActionId id, QObject* context, std::function<void(bool)> run) const;
  /// These actions can be used only while a project is open and no page covers it.
  void needRun(std::initializer_list<ActionId> ids) const;
  /// The same, and only while `suits` returns true: called again when a run begins or ends, and
  /// when the method changes.
  void needRun(std::initializer_list<ActionId> ids, const std::function<bool()>& suits) const;
  /// Shows a dialog in front of the window.
  static void present(QWidget* dialog);

  /// From now on a view is given what is shown: setSnapshot(const TrackSnapshotPtr&), null when
  /// there is nothing to show.
  template <class View> void connectView(View* view) const {
    QObject::connect(&session, &SessionController::snapshotChanged, view, &View::setSnapshot);
  }
  /// The same for a view of images: live cameras that are late show their last one.
  template <class View> void connectImageView(View* view) const {
    QObject::connect(&session, &SessionController::snapshotChanged, view,
                     [view, run = &session](const TrackSnapshotPtr& snapshot) {
                       view->setSnapshot(run->withFilledFrames(snapshot));
                     });
  }
};

} // namespace dewpoint::ui
