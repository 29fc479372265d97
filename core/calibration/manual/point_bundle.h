// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::calibration {

/// Refines the poses of all cameras marked in `solved` together with the positions of the points. A
/// click has the standard deviation `settings.clickSigma`, and a measured position has the standard
/// deviation `settings.tapeSigma`.
void refineCamerasAndPoints(CameraRig& rig, const std::vector<bool>& solved,
                            const std::vector<MeasuredPoint>& points,
                            const PointSettings& settings);

} // namespace dewpoint::calibration
