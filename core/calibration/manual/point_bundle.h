// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::calibration {

/// Poses of all cameras marked in `solved`, and the points, together: clicks weighted by
/// `settings.click`, the positions of the points by `settings.tape`.
void refineTogether(CameraRig& rig, const std::vector<bool>& solved,
                    const std::vector<MeasuredPoint>& points, const PointSettings& settings);

} // namespace dewpoint::calibration
