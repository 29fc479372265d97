// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// Returns the center of the body (world frame, meters) of a person visible at a pixel of a camera.
/// Of all positions in the method's area at which a standing body would cover the pixel, this is
/// the one that best fits the motion masks of all cameras. If there are no masks, it is the
/// position at which the center of the body appears closest to the pixel. `parameters` are those of
/// a method for people. Returns nothing if no person could stand there.
std::optional<Eigen::Vector3d> personAtPixel(const PeopleFinding& people, const CameraRig& rig,
                                             const ParameterValues& parameters, int camera,
                                             const Eigen::Vector2d& pixel);

/// Returns the center of the body of a person who stands at `position` (world x and y, meters).
Eigen::Vector3d bodyCenter(const Eigen::Vector2d& position, const ParameterValues& parameters);

} // namespace dewpoint::tracking
