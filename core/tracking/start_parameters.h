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

/// The volume in which a method starts: a box around a point, meters, world frame.
struct StartVolume {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero(); ///< half sizes; 0: a point
};

/// The declarations that all methods with a start volume share: start_x, start_half_x and so on.
std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults);
/// The start volume by the values of these parameters.
StartVolume startVolume(const ParameterValues& parameters);

/// The part of a start volume that lies in a box; all of the box where none does.
StartVolume within(const StartVolume& start, const WorldBox& box);

/// The key of the size of the room in which a target may appear, where a method has one.
inline constexpr const char* kSearchSizeKey = "search_size";

/// The parameters with which a method runs: what is declared to come from the cameras, and was not
/// given, is what they see (seenVolume()), within the volume of interest if there is one. The start
/// volume is that box and the search size its longest edge, in steps of their declarations. Where a
/// part of the start volume was given the rest of it has its defaults, and so has the search size.
ParameterValues parametersInUse(ParameterValues parameters, const CameraRig& rig,
                                const std::optional<WorldBox>& volumeOfInterest);

/// Draws `count` positions, uniform over the volume: rows x y z. Position i is drawn from element
/// i.
Eigen::ArrayXXd drawUniformly(const StartVolume& volume, Eigen::Index count,
                              const RandomStream& stream);

} // namespace dewpoint::tracking
