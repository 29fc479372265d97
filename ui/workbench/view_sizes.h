// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QSize>

#include <vector>

class QMainWindow;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class ViewDock;

/// Sizes of each kind of view for a given window size, in pixels. Camera images have priority.
struct ViewSizes {
  QSize cameraAreaSize; ///< maximum size of all camera views together
  /// Minimum width of all camera views together, used for two or more cameras.
  int minimumCameraAreaWidth = 0;
  int inspectorWidth = 0; ///< width of the docks at the right edge
  int sceneWidth = 0;     ///< width of the scene; 0 if it is hidden
  int plotHeight = 0;     ///< height of the plots
  int timelineHeight = 0; ///< height of the timeline
};

/// Approximate width of the separator between two docks, pixels.
inline constexpr int kDockSeparator = 6;

/// Returns the sizes of the views for the current size of a window. `inspectors` are all docks at
/// the right edge; their width is that of the widest visible one, or more if the names of their
/// tabs need more room.
ViewSizes viewSizesOf(const QMainWindow& window, const std::vector<ViewDock*>& inspectors,
                      const ViewDock& scene, const ViewDock& timeline);

/// Returns the image aspect ratio (width / height) of each camera, or a usual ratio if it is
/// unknown.
std::vector<double> imageAspectsOf(const project::Project& project, std::size_t cameras);

} // namespace dewpoint::ui
