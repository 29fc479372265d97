// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDockWidget>
#include <QString>

#include <functional>

namespace dewpoint::ui {

class DockTitle;

/// Where a dock stands in the arrangement that the window begins with.
enum class DockPlace {
  Cameras,   ///< to the left, in as many columns as keep the images near square
  Scene,     ///< right of the cameras
  Inspector, ///< tabs at the right edge
  History,   ///< below the inspector
  Plots,     ///< tabs below the cameras and the scene
  Timeline   ///< below the plots
};

/// What a dock is, declared once.
struct DockDeclaration {
  QString name;                   ///< objectName: layouts are saved by it
  std::function<QString()> title; ///< called again when the language changes
  QWidget* content;
  DockPlace place = DockPlace::Inspector;
  int rank = 100;              ///< among the docks that stand there: the lowest comes first
  bool hiddenAtFirst = false;  ///< until it is wanted
  bool openedByAction = false; ///< an action of its own shows it: the palette lists that one
};

/// A dock of the window, with the title that is common to all, and what is known of it besides Qt's
/// own state: whether the user put it away, and whether it lies behind another tab.
class ViewDock : public QDockWidget {
  Q_OBJECT
public:
  ViewDock(const DockDeclaration& declaration, QWidget* window);

  DockTitle& title() { return *title_; }
  DockPlace place() const { return place_; }
  int rank() const { return rank_; }
  bool isOpenedByAction() const { return openedByAction_; }
  /// Put away by the user or by the method: it is not shown with the other views.
  bool isHiddenByUser() const { return hiddenByUser_; }
  void setHiddenByUser(bool hidden) { hiddenByUser_ = hidden; }
  /// Wanted or put away from now on, and shown or hidden at once.
  void setWanted(bool wanted);
  /// Nothing of it is seen, because it lies behind another tab or is hidden.
  bool isBehind() const { return behind_; }
  /// Wanted, shown, and in front of its tabs.
  void bringToFront();
  /// Into a window of its own, beside where it was and in front, or back to its place.
  void toggleFloating();

protected:
  /// A view that was dragged out of the window gets its frame where it is let go.
  bool event(QEvent* event) override;
  /// Closed by the frame of its window: put away.
  void closeEvent(QCloseEvent* event) override;

Q_SIGNALS:
  /// The whole window is wanted for this dock, or no longer.
  void maximizeWanted();
  /// The user put it away or took it out again, in the list of views.
  void toggledByUser(bool shown);

private:
  /// Gives a floating view the frame of a window, so that it is moved and maximized like any other.
  void takeFrame();

  DockPlace place_;
  int rank_;
  bool hiddenByUser_;
  bool openedByAction_;
  bool behind_ = false;
  DockTitle* title_;
};

} // namespace dewpoint::ui
