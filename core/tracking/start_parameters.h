// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>

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

/// Draws `count` positions, uniform over the volume: rows x y z. Position i is drawn from element
/// i.
Eigen::ArrayXXd drawUniformly(const StartVolume& volume, Eigen::Index count,
                              const RandomStream& stream);

} // namespace dewpoint::tracking
