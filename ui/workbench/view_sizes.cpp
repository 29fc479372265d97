// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/view_sizes.h"

#include "core/project/project.h"
#include "ui/workbench/view_dock.h"

#include <QMainWindow>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>

namespace dewpoint::ui {

namespace {

// Chosen so that two cameras have about half of the width, and the scene remains large enough to be
// turned about in.
constexpr int kLeastOfCamerasPercent = 46; ///< of the width
constexpr int kLeastOfScenePercent = 22;   ///< of the width
constexpr int kPlotsPercent = 24;          ///< of the height
constexpr int kSmallHeight = 800;          ///< below it the timeline has as little as it needs
constexpr double kUsualAspect = 4.0 / 3.0; ///< of images whose size is not known yet

/// Width in which the names of all tabs of these docks can be read in full; 0 without tabs. Qt
/// would shorten them instead.
int widthOfTabs(const QMainWindow& window, const std::vector<ViewDock*>& docks) {
  int width = 0;
  for (const QTabBar* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
    const bool isTheirs = std::ranges::any_of(docks, [bar](const ViewDock* dock) {
      return !dock->isHidden() && bar->count() > 0 && bar->tabText(0) == dock->windowTitle();
    });
    width = std::max(width, isTheirs ? bar->sizeHint().width() : 0);
  }
  return width;
}

/// Menus, toolbars and status line.
int heightAroundViews(const QMainWindow& window) {
  int height = 0;
  for (const QWidget* bar :
       {window.menuWidget(), static_cast<QWidget*>(window.findChild<QStatusBar*>())}) {
    height += bar != nullptr ? bar->sizeHint().height() : 0;
  }
  for (const QToolBar* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    height += bar->isHidden() ? 0 : std::min(bar->sizeHint().height(), bar->maximumHeight());
  }
  return height;
}

} // namespace

ViewSizes viewSizesOf(const QMainWindow& window, const std::vector<ViewDock*>& inspectors,
                      const ViewDock& scene, const ViewDock& timeline) {
  ViewSizes sizes;
  for (const ViewDock* dock : inspectors) {
    const int least = std::max(dock->minimumWidth(), dock->minimumSizeHint().width());
    sizes.inspectorWidth = std::max(sizes.inspectorWidth, dock->isHidden() ? 0 : least);
  }
  sizes.inspectorWidth = std::max(sizes.inspectorWidth, widthOfTabs(window, inspectors));
  sizes.sceneWidth = scene.isHidden() ? 0
                                      : std::max(scene.minimumSizeHint().width(),
                                                 window.width() * kLeastOfScenePercent / 100);
  sizes.plotHeight = window.height() * kPlotsPercent / 100;
  sizes.timelineHeight = window.height() < kSmallHeight ? timeline.minimumSizeHint().height()
                                                        : timeline.sizeHint().height();
  sizes.minimumCameraAreaWidth = window.width() * kLeastOfCamerasPercent / 100;
  sizes.cameraAreaSize = QSize(window.width() - sizes.inspectorWidth - kDockSeparator -
                                   sizes.sceneWidth - (sizes.sceneWidth > 0 ? kDockSeparator : 0),
                               window.height() - heightAroundViews(window) - sizes.plotHeight -
                                   sizes.timelineHeight - 2 * kDockSeparator)
                             .expandedTo({1, 1});
  return sizes;
}

std::vector<double> imageAspectsOf(const Project& project, std::size_t cameras) {
  std::vector<double> aspects(cameras, kUsualAspect);
  for (std::size_t k = 0; k < std::min(cameras, project.cameras.size()); ++k) {
    const auto& lens = project.cameras[k].camera.intrinsics;
    if (lens.width > 0 && lens.height > 0) {
      aspects[k] = static_cast<double>(lens.width) / static_cast<double>(lens.height);
    }
  }
  return aspects;
}

} // namespace dewpoint::ui
