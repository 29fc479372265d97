// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Returns the fraction of a ball's disk, 0 to 1, that `parts` hide from the viewpoint `eye`. It is
/// estimated from kDiskPoints points spread evenly over the disk. World frame, meters. The result
/// is 1 if the viewpoint is inside the ball.
double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Returns the fraction of a ball's disk, 0 to 1, that overlaps with one of the parts as seen from
/// the viewpoint `eye`. It does not matter whether the part is in front of the ball or behind it.
double overlappedFraction(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                          const std::vector<simulation::MovingPart>& parts);

/// Converts a stage box at a time (seconds) to a part, in the world frame.
simulation::MovingPart boxPart(const simulation::StageBody& box, double time = 0.0);

/// Number of frames between two checks of hiddenShare() or overlappedFraction() in a scenario. In
/// that time, a ball on a slow path moves by less than its radius.
inline constexpr std::int64_t kFractionCheckInterval = 3;

/// Number of points on the disk. With this number, fractions are accurate to about a hundredth.
inline constexpr int kDiskPoints = 150;

} // namespace dewpoint::experiment::scenarios
