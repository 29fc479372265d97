// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Volume in which a method first searches for a target: a box around a point, in meters, world
/// frame.
struct StartVolume {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d halfSize = Eigen::Vector3d::Zero(); ///< half the edge lengths; 0: a single point
};

/// Returns the declarations of the parameters of a start volume: start_x, start_half_x and so on.
/// All methods with a start volume use these declarations.
std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults);
/// Returns the start volume that `parameters` define. `parameters` must declare startParameters().
StartVolume startVolumeOf(const ParameterValues& parameters);

/// Returns the part of a start volume inside a box, or the whole box if the two do not overlap.
StartVolume startVolumeWithin(const StartVolume& start, const WorldBox& box);

/// Key of the parameter for the size of the room in which a target may appear. Not all methods have
/// this parameter.
inline constexpr const char* kSearchSizeKey = "search_size";

/// Returns the parameters with all values filled in. Values that are not given
/// (ParameterValues::isGiven()) are derived from the box that the cameras see (seenVolume()),
/// limited to the volume of interest if there is one. This box becomes the start volume, and the
/// longest edge of the box becomes the search size; both are rounded to the steps in the
/// declarations. If any parameter of the start volume is given, nothing is derived, and the other
/// values are the defaults.
ParameterValues effectiveParameters(ParameterValues parameters, const CameraRig& rig,
                                    const std::optional<WorldBox>& volumeOfInterest);

/// Draws `count` positions uniformly from the volume: rows of x, y, z in meters, world frame.
/// Position i is drawn from element i of the stream.
Eigen::ArrayXXd drawUniformPositions(const StartVolume& volume, Eigen::Index count,
                                     const RandomStream& stream);

} // namespace dewpoint::tracking
