// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// Where a method starts to look: a box around a point, metres, world frame.
struct StartVolume {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero(); ///< half sizes; 0: exactly there
};

/// The declarations that all methods share: start_x, start_half_x and so on.
std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults);
/// Their values.
StartVolume startVolume(const ParameterValues& parameters);

/// `count` places, uniform over the volume: rows x y z. Place i is drawn from element i.
Eigen::ArrayXXd drawUniformly(const StartVolume& volume, Eigen::Index count,
                              const RandomStream& stream);

} // namespace dewpoint::tracking
