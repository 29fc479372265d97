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

/// The docks of the window: makes and arranges them, maximizes and restores one, hides all while a
/// page fills the center of the window, and keeps their layout in the document. As long as nobody
/// has arranged them otherwise, they are arranged for the size that the window has.
class DockManager : public QObject {
  Q_OBJECT
public:
  /// The central widget of the window shows the pages.
  DockManager(QMainWindow& window, Document& document, const SessionController& session,
              QObject* parent = nullptr);

  ViewDock* make(const DockDeclaration& declaration);
  /// Takes a dock, with its view, out of the window for good.
  void remove(ViewDock* dock);
  /// All there are, in the order of the window's children.
  std::vector<ViewDock*> docks() const;
  /// Whether a widget is in a dock of which nothing is seen.
  static bool isBehind(const QWidget* widget);

  /// The arrangement that the window begins with, then that of the document, if it has one.
  void layOut();
  /// Forgets the document's arrangement, and what was put away of the cameras.
  void reset();
  /// Gives the views the sizes that suit the window, once the layout has settled; nothing when
  /// somebody has arranged them otherwise.
  void distributeDockSizesSoon();
  /// Room above the views comes or goes (`kept`), or has (not `kept`): the images take it, and what
  /// lies below them stays.
  void keepHeightsBelow(bool kept);
  /// Puts the layout into the document: that of all views, also while one fills the window or a
  /// page hides them.
  void storeLayout();

  /// Shows the views, or the page in the center of the window.
  void showViews(bool shown);
  /// The views of another project follow: those put aside do not come back.
  void forgetLayoutBehindPages() { layoutBehindPages_.clear(); }

  /// Maximizes a dock, or restores all views; a floating dock is docked again.
  void toggleMaximized(ViewDock* dock);
  void restoreMaximized();
  /// The dock that fills the window; null when none does.
  ViewDock* maximized() const { return maximized_; }

Q_SIGNALS:
  void made(ViewDock* dock);
  /// The docks have been arranged again: modes of the window show theirs.
  void laidOut();
  /// The views, or the page, are about to come, and have come.
  void viewsShowing(bool shown);
  void viewsShown(bool shown);

protected:
  /// Of the window: another size, a separator that is dragged, and Esc, which gives all views back.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::vector<ViewDock*> at(DockPlace place) const;
  ViewDock* first(DockPlace place) const {
    const std::vector<ViewDock*> found = at(place);
    return found.empty() ? nullptr : found.front();
  }
  void arrange();
  void arrangeCameras(ViewDock* scene);
  /// Cameras stand in so many columns from now on; what is hidden or in front stays so.
  void rearrange(int columns);
  ViewShares shares() const;
  ImageGrid cameraGrid(const QSize& room) const;
  void distributeDockSizes();
  void distributeCameras(const ImageGrid& grid, int height);
  QByteArray save() const;
  /// The version of the layout.
  int restore(const QByteArray& layout);
  void maximize(ViewDock* dock);

  QMainWindow& window_;
  Document& document_;
  const SessionController& session_;
  DockNames* names_;
  int cameraColumns_ = 0;    ///< in which the cameras stand; 0: not arranged yet
  bool suitsSize_ = true;    ///< nobody has arranged the views otherwise
  bool arranging_ = false;   ///< what moves now, nobody has moved
  bool separator_ = false;   ///< the pointer was pressed on one
  int adjustments_ = 0;      ///< so often are sizes given soon
  HeldHeights heightsBelow_; ///< of what lies below, while messages come and go
  ViewDock* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  /// Which docks were put away when one was maximized.
  std::vector<std::pair<ViewDock*, bool>> hiddenBeforeMaximized_;
  QByteArray layoutBehindPages_; ///< of the views while a page hides them
};

} // namespace dewpoint::ui
