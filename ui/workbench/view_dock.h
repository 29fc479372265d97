// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDockWidget>
#include <QString>

#include <functional>

namespace dewpoint::ui {

class DockTitle;

/// Position of a dock in the default arrangement.
enum class DockArea {
  Cameras,   ///< on the left, in the number of columns that makes the images largest
  Scene,     ///< to the right of the cameras
  Inspector, ///< tabs at the right edge
  History,   ///< below the inspector
  Plots,     ///< tabs below the cameras and the scene
  Timeline   ///< below the plots
};

/// Declaration of one dock.
struct DockDeclaration {
  QString name;                   ///< objectName, used in saved layouts
  std::function<QString()> title; ///< called again when the language changes
  QWidget* content;
  DockArea area = DockArea::Inspector;
  int orderInArea = 100;         ///< order among the docks at this position, lowest first
  bool isHiddenAtFirst = false;  ///< hidden until the user opens it
  bool isOpenedByAction = false; ///< an action shows the dock, so the command palette lists this
                                 ///< action instead of the dock
};

/// Dock in the window with a DockTitle. In addition to Qt's state, it stores whether the user hid
/// the dock and whether the dock is behind another tab.
class ViewDock : public QDockWidget {
  Q_OBJECT
public:
  ViewDock(const DockDeclaration& declaration, QWidget* window);

  DockTitle& title() { return *title_; }
  DockArea area() const { return area_; }
  int orderInArea() const { return orderInArea_; }
  bool isOpenedByAction() const { return openedByAction_; }
  /// Returns whether the user hid the dock, or the current method does not use it. Such a dock
  /// stays hidden when the other views are shown.
  bool isHiddenByUser() const { return hiddenByUser_; }
  void setHiddenByUser(bool hidden) { hiddenByUser_ = hidden; }
  /// Shows or hides the dock, and stores this as the user's choice.
  void setShownByUserChoice(bool wanted);
  /// Returns whether no part of the dock is visible, because it is behind another tab or hidden.
  bool isBehindOtherDocks() const { return behind_; }
  /// Shows the dock in front of the docks that are tabbed with it, and stores as the user's choice
  /// that it is shown.
  void bringToFront();
  /// Moves the dock into its own window, next to its former position and in front, or puts it back.
  void toggleFloating();

protected:
  /// Adds the window frame to a view when it is dropped outside the window.
  bool event(QEvent* event) override;
  /// Hides the dock when the user closes its window.
  void closeEvent(QCloseEvent* event) override;

Q_SIGNALS:
  /// Emitted when the user wants to maximize this dock or restore the other views.
  void maximizeRequested();
  /// Emitted when the user hides or shows the dock in the list of views, or closes its window.
  void toggledByUser(bool shown);

private:
  /// Gives a floating view a window frame, so that it can be moved and maximized like any other
  /// window.
  void addWindowFrame();

  DockArea area_;
  int orderInArea_;
  bool hiddenByUser_;
  bool openedByAction_;
  bool behind_ = false;
  DockTitle* title_;
};

} // namespace dewpoint::ui
