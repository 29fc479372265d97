// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// Returns the center of the body (world frame, meters) of a person visible at a pixel of a camera.
/// The candidates are all positions in the method's area at which a standing body would cover the
/// pixel. The result is the candidate that best fits the motion masks of all cameras. Without
/// masks, it is the candidate whose body center appears closest to the pixel. Returns nothing if
/// there is no candidate. `parameters` must belong to a method for people.
std::optional<Eigen::Vector3d> personCenterAtPixel(const PeopleFinding& people,
                                                   const CameraRig& rig,
                                                   const ParameterValues& parameters, int camera,
                                                   const Eigen::Vector2d& pixel);

/// Returns the center of the body (world frame, meters) of a person of usual height who stands at
/// `position` (world x and y, meters). `parameters` must belong to a method for people.
Eigen::Vector3d bodyCenter(const Eigen::Vector2d& position, const ParameterValues& parameters);

} // namespace dewpoint::tracking
