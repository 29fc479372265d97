// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A polyline through points of the world (meters): "board" (thin, amber) or another CSS class of
/// the page.
struct SpaceLine {
  const char* kind = "board";
  std::vector<Eigen::Vector3d> points;
};

/// SVG with cameras and lines in space: obliquely from above (with this label), and from above.
std::string spaceDrawing(const CameraRig& cameras, const std::vector<SpaceLine>& lines,
                         const char* label);

} // namespace dewpoint::calibration
