// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Polyline through world points (meters). Its style is "board" (thin, amber) or another CSS class
/// of the page.
struct SpaceLine {
  const char* kind = "board";
  std::vector<Eigen::Vector3d> points;
};

/// Returns an SVG with two views of cameras and lines in space: one obliquely from above, and one
/// from directly above. `label` is the title of the first view.
std::string spaceDrawing(const CameraRig& cameras, const std::vector<SpaceLine>& lines,
                         const char* label);

} // namespace dewpoint::calibration
