// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/manual/measured_points.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Returns the position (world frame, m; m²) given by clicks on a target, at most one per camera,
/// all in images of one frame. The error of a click is assumed to be 2 px along each axis.
///
/// With several clicks, the position is the nearestPoint() of their rays. The covariance follows
/// from the errors of the clicks, and is larger if these errors do not explain the distance between
/// the rays. A single click does not determine the depth. The depth is then taken from `estimate`
/// (the target's estimate in this frame). The variance along the ray is the squared distance of the
/// estimate from the ray plus the estimate's own variance along the ray. Without an estimate in
/// front of the camera, the position is on the part of the ray that the largest number of other
/// cameras sees. This part may extend to infinity, so its inverse depths are assumed to be
/// uniformly distributed: the position is at their center, and their variance determines the
/// variance along the ray.
///
/// Returns BadValue if there is no click, or if a camera does not exist. Returns Undetermined with
/// the name of a camera if its lens does not cover the clicked pixel, or if no other camera sees
/// any part of the ray. Returns Undetermined with "clicks" if the rays do not meet in front of the
/// cameras.
Result<Gaussian3> positionFromClicks(const CameraRig& rig, const std::vector<PointClick>& clicks,
                                     const std::optional<Gaussian3>& estimate);

} // namespace dewpoint::setup
