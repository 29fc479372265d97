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

/// Shared parts of the window. Every feature of the window receives them in its constructor or
/// install function, and uses them to create its dock, connect its actions and receive snapshots.
/// No other part of the window knows about the feature.
struct Workbench {
  QMainWindow& window; ///< parent of docks, views and dialogs
  ActionRegistry& actions;
  Document& document;
  CameraListModel& cameras; ///< list model of the project's cameras
  TargetListModel& targets; ///< list model of the project's targets
  Selection& selection;
  SessionController& session;
  DockManager& docks;
  MessageBar& messages;

  /// Returns the action with this id.
  QAction* action(ActionId id) const;
  void onTriggered(ActionId id, QObject* context, std::function<void()> run) const;
  void onToggled(ActionId id, QObject* context, std::function<void(bool)> run) const;
  /// Enables these actions only while a project is open and no page covers the views.
  void requireRun(std::initializer_list<ActionId> ids) const;
  /// Enables these actions only while a project is open, no page covers the views, and `suits`
  /// returns true. `suits` is called again when a run begins or ends, and when the method changes.
  void requireRun(std::initializer_list<ActionId> ids, const std::function<bool()>& suits) const;
  /// Shows a dialog in front of the window.
  static void presentDialog(QWidget* dialog);

  /// Connects a view to the snapshots: calls view->setSnapshot(const TrackSnapshotPtr&) with each
  /// new snapshot, and with null when there is nothing to show.
  template <class View> void connectView(View* view) const {
    QObject::connect(&session, &SessionController::snapshotChanged, view, &View::setSnapshot);
  }
  /// Connects a view of images to the snapshots: calls view->setSnapshot() with each new snapshot,
  /// in which live cameras whose image is delayed keep their last image, and with null when there
  /// is nothing to show.
  template <class View> void connectImageView(View* view) const {
    QObject::connect(&session, &SessionController::snapshotChanged, view,
                     [view, run = &session](const TrackSnapshotPtr& snapshot) {
                       view->setSnapshot(run->withMissingImagesFilled(snapshot));
                     });
  }
};

} // namespace dewpoint::ui
