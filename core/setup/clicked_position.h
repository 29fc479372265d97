// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/manual/measured_points.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// The position (world, m; m²) that clicks on a target stand for, at most one per camera, all in
/// images of one frame. A click is taken to be off by 2 px along each axis.
///
/// Several clicks: the nearestPoint() of their rays; the covariance is that of the clicks' errors,
/// larger where the rays miss each other by more than these explain. One click leaves the depth
/// open: it is that of `estimate`, the target's at this frame, and as far off along the ray as the
/// estimate is across it, besides the estimate's own error. Without an estimate in front of the
/// camera it is the middle of the part of the ray that most other cameras see, of its inverse depth
/// (it may be endless), and its error that of a uniform distribution over that part.
///
/// BadValue: no click, or a camera that is not there. Undetermined names the camera whose lens
/// shows nothing at the pixel, or of whose ray no other camera sees anything; "clicks" when the
/// rays do not meet in front of the cameras.
Result<Gaussian3> clickedPosition(const CameraRig& rig, const std::vector<PointClick>& clicks,
                                  const std::optional<Gaussian3>& estimate);

} // namespace dewpoint::setup
