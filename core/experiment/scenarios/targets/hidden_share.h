// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Share of a ball's disk, 0 to 1, that parts hide from a viewpoint `eye`. It is counted on
/// kDiscPoints points spread evenly over the disk. World frame, meters. 1 if the viewpoint is
/// inside the ball.
double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Share of a ball's disk, 0 to 1, that has one of the parts before or behind it.
double backedShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Converts a box of the stage at a time to a part, in the world frame.
simulation::MovingPart boxPart(const simulation::StageBody& box, double time = 0.0);

/// Frames between two checks of shares by scenarios. Meanwhile a ball on a smooth path moves by
/// about its radius, which changes a share by a few hundredths.
inline constexpr std::int64_t kShareEvery = 3;

/// Points of the disk; a share is accurate to about a hundredth.
inline constexpr int kDiscPoints = 150;

} // namespace dewpoint::experiment::scenarios
