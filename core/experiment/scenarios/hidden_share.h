// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Share of a ball's disc, 0 to 1, that parts hide from an eye: counted on kDiscPoints points that
/// are spread evenly over the disc. World frame, meters. 1 if the eye is inside the ball.
double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Share of a ball's disc, 0 to 1, that has one of the parts before or behind it.
double backedShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Points of the disc: a share is known to about a hundredth.
inline constexpr int kDiscPoints = 150;

} // namespace dewpoint::experiment::scenarios
