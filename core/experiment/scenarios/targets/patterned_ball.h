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
  OnePatch,     ///< 22 to 32 mm wide on a ball of 70 mm
  TwoPatches,   ///< large ones, separate: half angles of 35 to 45 degrees
  ThreePatches, ///< the same size: a beach ball
  SixSpots,     ///< on all sides: half angles of 14 to 18 degrees
  Seams,        ///< two intersecting great circles, 5 to 7 mm wide on a ball of 70 mm
  TwoColors,    ///< half of the ball has another color
  Highlight,    ///< no paint, but shiny: a clipped highlight
};

/// Rotation of a ball about an axis at a constant rate.
struct Spin {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< unit vector, world
  double rate = 0.0;                               ///< radians per second
  /// Axes of the ball in the world, as rows, at a time in seconds.
  Eigen::Matrix3f axesAt(double time) const;
};

/// Rotations per second of a ball that rolls in the hand or dangles; chosen.
inline constexpr double kSlowestSpin = 0.25;
inline constexpr double kFastestSpin = 1.0;

/// Draws a rotation about a random axis with `least` to `most` rotations per second.
Spin drawSpin(Draws& draws, double least, double most);

/// Paints a ball of the stage; positions of the paint are random.
void paintBall(simulation::StageBody& ball, BallPattern pattern, const Spin& spin, Draws& draws);

} // namespace dewpoint::experiment::scenarios
