// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Returns the fraction of a ball's disk, 0 to 1, that `parts` hide from the viewpoint `eye`; 1 if
/// the viewpoint is inside the ball. The fraction is estimated from kDiskPoints points spread
/// evenly over the disk. World frame, meters.
double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Returns the fraction of a ball's disk, 0 to 1, that overlaps with any of the parts as seen from
/// the viewpoint `eye`, whether a part is in front of the ball or behind it. World frame, meters.
double overlappedFraction(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                          const std::vector<simulation::MovingPart>& parts);

/// Converts a box of the simulated scene, as it is at a time (seconds), to a part that may hide a
/// ball, as hiddenShare() needs it. World frame.
simulation::MovingPart boxPart(const simulation::StageBody& box, double time = 0.0);

/// Number of frames between two checks of hiddenShare() or overlappedFraction() in a scenario: few
/// enough that a ball on a slow path moves by less than its radius.
inline constexpr std::int64_t kFractionCheckInterval = 3;

/// Number of points on a ball's disk from which hidden fractions are estimated, so that they are
/// accurate to about a hundredth.
inline constexpr int kDiskPoints = 150;

} // namespace dewpoint::experiment::scenarios
