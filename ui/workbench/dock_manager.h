// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/dock_arrangement.h"
#include "ui/workbench/held_heights.h"
#include "ui/workbench/view_dock.h"

#include <QByteArray>
#include <QObject>

#include <utility>
#include <vector>

class QMainWindow;

namespace dewpoint::ui {

class DockNames;
class Document;
class SessionController;

/// Docks of the window: creates and arranges them, maximizes and restores one, hides all while a
/// page fills the center of the window, and stores their layout in the document. Until the user
/// rearranges them, they are arranged to suit the size of the window.
class DockManager : public QObject {
  Q_OBJECT
public:
  /// The central widget of `window` must show the pages.
  DockManager(QMainWindow& window, Document& document, const SessionController& session,
              QObject* parent = nullptr);

  ViewDock* make(const DockDeclaration& declaration);
  /// Removes a dock and its view from the window permanently.
  void remove(ViewDock* dock);
  /// All there are, in the order of the window's children.
  std::vector<ViewDock*> docks() const { return arrangement_.docks(); }
  /// Whether a widget is in a dock of which nothing is seen.
  static bool isBehind(const QWidget* widget);

  /// Applies the default arrangement, then the one of the document if it has one.
  void layOut();
  /// Restores the default arrangement, also of hidden camera views, and drops that of the document.
  void reset();
  /// Resizes the views to suit the window once the layout has settled; does nothing if the user has
  /// rearranged them.
  void distributeDockSizesSoon();
  /// Call with `kept` true before the height above the views changes, and with false afterwards:
  /// the images take or give the room, and the docks below them keep their heights.
  void keepHeightsBelow(bool kept);
  /// Stores the layout of all views in the document, also while one is maximized or a page hides
  /// them.
  void storeLayout();

  /// Shows the views, or the page in the center of the window.
  void showViews(bool shown);
  /// Drops the layout saved behind a page, because the views of another project follow.
  void forgetLayoutBehindPages() { layoutBehindPages_.clear(); }

  /// Maximizes a dock, or restores all views; docks a floating dock again.
  void toggleMaximized(ViewDock* dock);
  void restoreMaximized();
  /// Dock that fills the window; null if none does.
  ViewDock* maximized() const { return maximized_; }

Q_SIGNALS:
  void made(ViewDock* dock);
  /// The docks have been arranged again; modes of the window show theirs.
  void laidOut();
  /// The views or the page are about to be shown, and have been shown.
  void viewsShowing(bool shown);
  void viewsShown(bool shown);

protected:
  /// Handles events of the window: resizing, dragging a separator, and Esc, which restores all
  /// views.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void arrange();
  /// Arranges the cameras in this number of columns; docks that are hidden or in front stay so.
  void rearrange(int columns);
  void distributeDockSizes();
  QByteArray save() const;
  /// Restores a layout and returns its version.
  int restore(const QByteArray& layout);
  void maximize(ViewDock* dock);

  QMainWindow& window_;
  Document& document_;
  const SessionController& session_;
  DockNames* names_;
  DockArrangement arrangement_;
  bool suitsSize_ = true;    ///< nobody has arranged the views otherwise
  bool arranging_ = false;   ///< what moves now, nobody has moved
  bool separator_ = false;   ///< the pointer was pressed on one
  int adjustments_ = 0;      ///< so often are sizes given soon
  HeldHeights heightsBelow_; ///< of what lies below, while messages come and go
  ViewDock* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  /// Docks, and whether they were hidden, when one was maximized.
  std::vector<std::pair<ViewDock*, bool>> hiddenBeforeMaximized_;
  QByteArray layoutBehindPages_; ///< layout of the views while a page hides them
};

} // namespace dewpoint::ui
