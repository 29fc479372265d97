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

class DockNamePlacement;
class Document;
class SessionController;

/// Manages the docks in the window: creates and arranges them, maximizes and restores one, hides
/// all while a page fills the center of the window, and stores their layout in the document. Until
/// the user rearranges them, they are arranged to suit the window size.
class DockManager : public QObject {
  Q_OBJECT
public:
  /// Creates the manager. The central widget of `window` must show the pages that replace the
  /// views.
  DockManager(QMainWindow& window, Document& document, const SessionController& session,
              QObject* parent = nullptr);

  ViewDock* makeDock(const DockDeclaration& declaration);
  /// Removes a dock and its view from the window permanently.
  void removeDock(ViewDock* dock);
  /// Returns all docks, in the order of the window's children.
  std::vector<ViewDock*> docks() const { return arrangement_.docks(); }
  /// Returns whether a widget is in a dock of which no part is visible.
  static bool isBehindOtherDocks(const QWidget* widget);

  /// Applies the default arrangement, followed by the document's layout if it has one.
  void layOut();
  /// Restores the default arrangement, including hidden camera views, and discards the document's
  /// layout.
  void resetLayout();
  /// Resizes the views to suit the window, once the layout has settled. Does nothing if the user
  /// has rearranged the views.
  void distributeDockSizesSoon();
  /// Keeps the heights of the docks below the images while the height of the area above the views
  /// changes, so that only the images shrink or grow. Call this with true before the change, and
  /// with false afterward.
  void lockLowerDockHeights(bool locked);
  /// Stores the layout of all views in the document, even while one is maximized or a page hides
  /// them.
  void storeLayout();

  /// Shows the views if `shown` is true, or the page in the center of the window instead.
  void showViews(bool shown);
  /// Discards the layout that was saved when a page replaced the views. Call this before the views
  /// of another project are shown.
  void forgetLayoutBehindPages() { layoutBehindPages_.clear(); }

  /// Maximizes a dock or, if a dock is maximized, restores all views. A floating dock is only put
  /// back into the window.
  void toggleMaximized(ViewDock* dock);
  void restoreMaximized();
  /// Returns the dock that fills the window, or null if there is none.
  ViewDock* maximizedDock() const { return maximized_; }

Q_SIGNALS:
  void dockCreated(ViewDock* dock);
  /// Emitted when the docks have been arranged again. Modes such as calibration must then show
  /// their docks.
  void layoutChanged();
  /// viewsAboutToChange() is emitted before the views are shown (true) or replaced by a page
  /// (false), viewsShownChanged() afterward.
  void viewsAboutToChange(bool shown);
  void viewsShownChanged(bool shown);

protected:
  /// Handles window events: resizing, dragging a separator, and Esc, which restores all views.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void arrange();
  /// Arranges the cameras in this number of columns. Hidden docks stay hidden, and docks in front
  /// stay in front.
  void rearrange(int columns);
  void distributeDockSizes();
  QByteArray save() const;
  /// Restores a layout and returns its version.
  int restore(const QByteArray& layout);
  void maximize(ViewDock* dock);

  QMainWindow& window_;
  Document& document_;
  const SessionController& session_;
  DockNamePlacement* names_;
  DockArrangement arrangement_;
  bool suitsSize_ = true;    ///< the user has not rearranged the views
  bool arranging_ = false;   ///< docks are being moved by the program, not by the user
  bool separator_ = false;   ///< the pointer was pressed on a separator
  int adjustments_ = 0;      ///< remaining number of times to set the sizes
  HeldHeights heightsBelow_; ///< heights of the lower docks while messages come and go
  ViewDock* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  /// All docks at the time when one was maximized, each with whether it was hidden.
  std::vector<std::pair<ViewDock*, bool>> hiddenBeforeMaximized_;
  QByteArray layoutBehindPages_; ///< layout of the views while a page hides them
};

} // namespace dewpoint::ui
