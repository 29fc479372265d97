// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Share of a ball's disc, 0 to 1, that parts hide from an eye: counted on kDiscPoints points that
/// are spread evenly over the disc. World frame, meters. 1 if the eye is inside the ball.
double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// Share of a ball's disc, 0 to 1, that has one of the parts before or behind it.
double backedShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts);

/// A box of the stage at a time as a part, in the world.
simulation::MovingPart boxPart(const simulation::StageBody& box, double time = 0.0);

/// Frames between two at which scenarios check shares. A ball on a smooth path moves by about its
/// radius meanwhile, which changes a share by a few hundredths.
inline constexpr std::int64_t kShareEvery = 3;

/// Points of the disc: a share is known to about a hundredth.
inline constexpr int kDiscPoints = 150;

} // namespace dewpoint::experiment::scenarios
