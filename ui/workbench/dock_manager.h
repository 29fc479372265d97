// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/held_heights.h"
#include "ui/workbench/image_grid.h"
#include "ui/workbench/view_dock.h"
#include "ui/workbench/view_shares.h"

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
  /// All docks, in the order of the children of the window.
  std::vector<ViewDock*> docks() const;
  /// Whether a widget is in a dock that is not visible at all.
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
  std::vector<ViewDock*> at(DockPlace place) const;
  ViewDock* first(DockPlace place) const {
    const std::vector<ViewDock*> found = at(place);
    return found.empty() ? nullptr : found.front();
  }
  void arrange();
  void arrangeCameras(ViewDock* scene);
  /// Arranges the cameras in this number of columns; hidden docks stay hidden and front tabs stay
  /// in front.
  void rearrange(int columns);
  ViewShares shares() const;
  ImageGrid cameraGrid(const QSize& room) const;
  void distributeDockSizes();
  void distributeCameras(const ImageGrid& grid, int height);
  QByteArray save() const;
  /// Restores a layout and returns its version.
  int restore(const QByteArray& layout);
  void maximize(ViewDock* dock);

  QMainWindow& window_;
  Document& document_;
  const SessionController& session_;
  DockNames* names_;
  int cameraColumns_ = 0;    ///< columns of the camera views; 0: not arranged yet
  bool suitsSize_ = true;    ///< false after the user has rearranged the views
  bool arranging_ = false;   ///< docks are being moved by the program
  bool separator_ = false;   ///< the pointer was pressed on a separator
  int adjustments_ = 0;      ///< number of scheduled resizings
  HeldHeights heightsBelow_; ///< heights of the docks below while messages come and go
  ViewDock* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  /// Docks, and whether they were hidden, when one was maximized.
  std::vector<std::pair<ViewDock*, bool>> hiddenBeforeMaximized_;
  QByteArray layoutBehindPages_; ///< layout of the views while a page hides them
};

} // namespace dewpoint::ui
