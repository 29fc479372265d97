// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A line through points of the world: "board" (thin, amber) or another class of the page.
struct SpaceLine {
  const char* kind = "board";
  std::vector<Eigen::Vector3d> points;
};

/// Cameras and lines in space: from the side above (with this label), and from above. SVG.
std::string spaceDrawing(const CameraRig& cameras, const std::vector<SpaceLine>& lines,
                         const char* label);

} // namespace dewpoint::calibration
