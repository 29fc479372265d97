// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// Radius of a ball where nothing else is said, meters: about that of a tennis ball (33 mm).
inline constexpr double kUsualBallRadius = 0.035;
/// Radius of the balls in the hall, meters: four times as far from the cameras as on the desk, they
/// measure about as many pixels.
inline constexpr double kHallBallRadius = 0.10;
/// Color of a ball where nothing else is said: pink as in Barrera et al. (2005), which nothing else
/// in the rooms is. BGR in full light, [0, 255].
inline const Eigen::Vector3d kUsualBallColor{145.0, 85.0, 245.0};

} // namespace dewpoint::simulation
