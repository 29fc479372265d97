// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/simulation/scene/stage.h"
#include "core/simulation/surface/surface_pattern.h"

#include <Eigen/Core>

#include <numbers>

namespace dewpoint::experiment::scenarios {

/// Pattern painted on a ball.
enum class BallPattern {
  OnePatch,     ///< one patch, 22 to 32 mm wide on a ball of 70 mm diameter
  TwoPatches,   ///< two large, separate patches with half angles of 35 to 45 degrees
  ThreePatches, ///< three patches of the same size, as on a beach ball
  SixSpots,     ///< six spots on all sides, with half angles of 14 to 18 degrees
  Seams,        ///< two intersecting great circles, 5 to 7 mm wide on a ball of 70 mm diameter
  TwoColors,    ///< half of the ball has a second color
  Highlight,    ///< no paint; the ball is so shiny that its highlight is clipped
};

/// Rotation of a ball about an axis at a constant rate.
struct Spin {
  /// Axis of the rotation: unit vector, world frame.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double radiansPerSecond = 0.0; ///< rate of the rotation, radians per second
  /// Returns the ball axes in the world frame, as rows, at a time in seconds.
  Eigen::Matrix3f axesAt(double time) const;
};

/// Slowest and fastest rotation of a ball that rolls in a hand or dangles, in rotations per second.
/// Chosen by judgment.
inline constexpr double kSlowestSpin = 0.25;
inline constexpr double kFastestSpin = 1.0;

/// Draws a rotation about a random axis with `least` to `most` rotations per second.
Spin randomSpin(RandomDraws& draws, double least, double most);

/// Paints a pattern on a ball of the simulated scene, at random positions. The pattern rotates with
/// `spin`.
void paintBall(simulation::StageBody& ball, BallPattern pattern, const Spin& spin,
               RandomDraws& draws);

} // namespace dewpoint::experiment::scenarios
