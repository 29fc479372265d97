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

/// What a window of its size gives to each kind of view: images first. Pixels.
struct ViewShares {
  QSize cameras;           ///< as much as all camera views may have together
  int leastForCameras = 0; ///< width that two cameras and more have at least
  int inspector = 0;       ///< width
  int scene = 0;           ///< width that the scene keeps; 0: it is hidden
  int plots = 0;           ///< height
  int timeline = 0;        ///< height
};

/// Between two docks, about.
inline constexpr int kDockSeparator = 6;

/// `inspectors`: all that stand there; the widest that is shown counts.
ViewShares viewSharesOf(const QMainWindow& window, const std::vector<ViewDock*>& inspectors,
                        const ViewDock& scene, const ViewDock& timeline);

/// Width / height of the images of each camera, as far as they are known.
std::vector<double> imageAspectsOf(const project::Project& project, std::size_t cameras);

} // namespace dewpoint::ui
