// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// The center of the body (world, meters) of a person who is seen at a pixel of a camera: of all
/// standing bodies in the area of the method that cover the pixel, the one that the motion masks of
/// all cameras speak for most; without any masks, the one whose center is nearest to the pixel.
/// `parameters` are those of a method for people. Nothing when nobody could stand there.
std::optional<Eigen::Vector3d> personAtPixel(const PeopleFinding& people, const CameraRig& rig,
                                             const ParameterValues& parameters, int camera,
                                             const Eigen::Vector2d& pixel);

/// The center of the body of a person who stands at `position` (world x and y, meters).
Eigen::Vector3d bodyCenter(const Eigen::Vector2d& position, const ParameterValues& parameters);

} // namespace dewpoint::tracking
