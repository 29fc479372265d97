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

/// Volume in which a method starts: a box around a point, in meters, world frame.
struct StartVolume {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero(); ///< half the edge lengths; 0: a single point
};

/// Returns the declarations shared by all methods with a start volume: start_x, start_half_x and so
/// on.
std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults);
/// Returns the start volume given by these parameters.
StartVolume startVolume(const ParameterValues& parameters);

/// Returns the part of a start volume inside a box, or the whole box if they do not overlap.
StartVolume within(const StartVolume& start, const WorldBox& box);

/// Key of the parameter for the size of the room in which a target may appear. Not all methods have
/// this parameter.
inline constexpr const char* kSearchSizeKey = "search_size";

/// Returns the parameters used by a method. Parameters that were not given and are declared as
/// `fromCameras` are derived from the box that the cameras see (seenVolume()), limited to the
/// volume of interest if there is one. This box becomes the start volume, and its longest edge the
/// search size; both are rounded to the steps in the declarations. If a part of the start volume
/// was given, the rest of it and the search size keep their defaults.
ParameterValues effectiveParameters(ParameterValues parameters, const CameraRig& rig,
                                    const std::optional<WorldBox>& volumeOfInterest);

/// Draws `count` positions uniformly from the volume: rows of x, y, z in meters, world frame.
/// Position i is drawn from element i of the stream.
Eigen::ArrayXXd drawUniformly(const StartVolume& volume, Eigen::Index count,
                              const RandomStream& stream);

} // namespace dewpoint::tracking
