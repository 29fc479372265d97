// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// The middle of the body (world, meters) of somebody who is seen at a pixel of a camera: of all
/// standing bodies in the area of the method that cover the pixel, the one that the motion masks of
/// all cameras speak for most; without any masks, the one whose middle is nearest to the pixel.
/// `parameters` are those of a method for people. Nothing when nobody could stand there.
std::optional<Eigen::Vector3d> personAtPixel(const PeopleFinding& people, const CameraRig& rig,
                                             const ParameterValues& parameters, int camera,
                                             const Eigen::Vector2d& pixel);

/// The middle of somebody's body who stands at `place` (world x and y, meters).
Eigen::Vector3d middleOfBody(const Eigen::Vector2d& place, const ParameterValues& parameters);

} // namespace dewpoint::tracking
