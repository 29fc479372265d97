// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// Default radius of a ball in meters, about the radius of a tennis ball (33 mm).
inline constexpr double kDefaultBallRadius = 0.035;
/// Radius in meters of the balls in the hall (the simulated living room). These balls are four
/// times as far from the cameras as balls on the desk, so they have about the same size in pixels.
inline constexpr double kHallBallRadius = 0.10;
/// Default ball color, BGR in full light, [0, 255]: pink as in Barrera et al. (2005). Nothing else
/// in the simulated rooms has this color.
inline const Eigen::Vector3d kDefaultBallColor{145.0, 85.0, 245.0};

} // namespace dewpoint::simulation
