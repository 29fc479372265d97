// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/dock_arrangement.h"

#include "ui/document/document.h"
#include "ui/widgets/dock_title.h"

#include <QMainWindow>
#include <QtMath>

#include <algorithm>

namespace dewpoint::ui {

std::vector<ViewDock*> DockArrangement::docks() const {
  const auto found = window_.findChildren<ViewDock*>();
  return {found.begin(), found.end()};
}

std::vector<ViewDock*> DockArrangement::docksAt(DockArea place) const {
  std::vector<ViewDock*> found = docks();
  std::erase_if(found, [place](const ViewDock* dock) { return dock->area() != place; });
  std::ranges::stable_sort(found, {}, &ViewDock::orderInArea);
  return found;
}

ViewDock* DockArrangement::firstDockAt(DockArea place) const {
  const std::vector<ViewDock*> found = docksAt(place);
  return found.empty() ? nullptr : found.front();
}

void DockArrangement::placeDocks() {
  for (ViewDock* dock : docks()) {
    dock->setFloating(false);
    window_.removeDockWidget(dock); // or splits and tabs would build on what was
  }
  const auto below = docksAt(DockArea::Plots);
  window_.addDockWidget(Qt::BottomDockWidgetArea, below.front());
  ViewDock* last = below.front();
  for (ViewDock* dock : docksAt(DockArea::Timeline)) {
    window_.splitDockWidget(last, dock, Qt::Vertical);
    last = dock;
  }
  for (std::size_t i = 1; i < below.size(); ++i) {
    window_.tabifyDockWidget(below.front(), below[i]);
  }
  ViewDock* scene = firstDockAt(DockArea::Scene);
  placeCameras(scene);
  const auto inspector = docksAt(DockArea::Inspector);
  window_.splitDockWidget(scene, inspector.front(), Qt::Horizontal);
  for (ViewDock* dock : docksAt(DockArea::History)) { // before there are tabs
    window_.splitDockWidget(inspector.front(), dock, Qt::Vertical);
  }
  // One tab for each kind of thing that can be looked into.
  for (std::size_t i = 1; i < inspector.size(); ++i) {
    window_.tabifyDockWidget(inspector.front(), inspector[i]);
  }
}

void DockArrangement::placeCameras(ViewDock* scene) {
  window_.addDockWidget(Qt::LeftDockWidgetArea, scene);
  const std::vector<ViewDock*> cameras = docksAt(DockArea::Cameras);
  if (cameras.empty()) {
    return;
  }
  // Cameras stand to the left of the scene, in as many columns as show the largest images.
  const std::size_t count = cameras.size();
  if (cameraColumnCount_ < 1 || cameraColumnCount_ > static_cast<int>(count)) {
    cameraColumnCount_ = cameraGrid(viewSizes().cameraAreaSize).columnCount;
  }
  const auto columns = static_cast<std::size_t>(cameraColumnCount_);
  window_.removeDockWidget(scene);
  window_.addDockWidget(Qt::LeftDockWidgetArea, cameras.front());
  window_.splitDockWidget(cameras.front(), scene, Qt::Horizontal);
  for (std::size_t i = 1; i < std::min(columns, count); ++i) {
    window_.splitDockWidget(cameras[i - 1], cameras[i], Qt::Horizontal);
  }
  for (std::size_t i = columns; i < count; ++i) {
    window_.splitDockWidget(cameras[i - columns], cameras[i], Qt::Vertical);
  }
}

ViewSizes DockArrangement::viewSizes() const {
  return viewSizesOf(window_, docksAt(DockArea::Inspector), *firstDockAt(DockArea::Scene),
                     *firstDockAt(DockArea::Timeline));
}

ImageGrid DockArrangement::cameraGrid(const QSize& room) const {
  const auto cameras = docksAt(DockArea::Cameras);
  return bestImageGrid(imageAspectsOf(document_.project(), cameras.size()), room,
                       cameras.front()->title().sizeHint().height(), cameraColumnCount_);
}

int DockArrangement::bestCameraColumnCount() const {
  return docksAt(DockArea::Cameras).empty() ? cameraColumnCount_
                                            : cameraGrid(viewSizes().cameraAreaSize).columnCount;
}

void DockArrangement::distributeSizes() {
  const ViewSizes all = viewSizes();
  ViewDock* scene = firstDockAt(DockArea::Scene);
  const std::vector<ViewDock*> cameras = docksAt(DockArea::Cameras);
  QList<QDockWidget*> row;
  QList<int> widths;
  int left = window_.width() - all.inspectorWidth - kDockSeparator;
  if (!cameras.empty()) {
    const ImageGrid grid = cameraGrid(all.cameraAreaSize);
    // No wider than the images can use, if something else can.
    const int least = cameras.size() > 1 ? all.minimumCameraAreaWidth : 0;
    const int wanted =
        all.sceneWidth == 0
            ? all.cameraAreaSize.width()
            : std::min(all.cameraAreaSize.width(), std::max(least, qCeil(grid.maximumUsefulWidth)));
    for (std::size_t column = 0; column < grid.columnWidthShares.size(); ++column) {
      row.push_back(cameras[column]);
      widths.push_back(std::max(1, qRound(wanted * grid.columnWidthShares[column])));
    }
    left -= wanted + kDockSeparator * grid.columnCount;
  }
  if (all.sceneWidth > 0) {
    row.push_back(scene);
    widths.push_back(std::max(1, left));
  }
  row.push_back(firstDockAt(DockArea::Inspector));
  widths.push_back(all.inspectorWidth);
  window_.resizeDocks(row, widths, Qt::Horizontal);
  window_.resizeDocks({firstDockAt(DockArea::Plots), firstDockAt(DockArea::Timeline)},
                      {all.plotHeight, all.timelineHeight}, Qt::Vertical);
  if (!cameras.empty()) {
    distributeCameras(cameraGrid(all.cameraAreaSize), all.cameraAreaSize.height());
  }
}

void DockArrangement::distributeCameras(const ImageGrid& grid, int height) {
  const std::vector<ViewDock*> cameras = docksAt(DockArea::Cameras);
  QList<int> heights;
  for (const double share : grid.viewHeightShares) {
    heights.push_back(std::max(1, qRound(height * share)));
  }
  window_.resizeDocks({cameras.begin(), cameras.end()}, heights, Qt::Vertical);
}

} // namespace dewpoint::ui
