// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/simulation/scene/stage.h"
#include "core/simulation/surface/surface_pattern.h"

#include <Eigen/Core>

#include <numbers>

namespace dewpoint::experiment::scenarios {

/// What a ball is painted with.
enum class BallPattern {
  OnePatch,     ///< 22 to 32 mm wide on a ball of 70 mm
  TwoPatches,   ///< large ones, apart: half angles of 35 to 45 degrees
  ThreePatches, ///< the same: a beach ball
  SixSpots,     ///< on all sides: half angles of 14 to 18 degrees
  Seams,        ///< two great circles that cross, 5 to 7 mm wide on a ball of 70 mm
  TwoColors,    ///< half of the ball has another color
  Highlight,    ///< no paint, but shiny: a clipped highlight
};

/// How a ball rotates: about an axis at a constant rate.
struct Spin {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< unit vector, world
  double rate = 0.0;                               ///< radians per second
  /// The ball's own axes in the world, as rows, at a time in seconds.
  Eigen::Matrix3f axesAt(double time) const;
};

/// Rounds per second of a ball that rolls in the hand or dangles; chosen.
inline constexpr double kSlowestSpin = 0.25;
inline constexpr double kFastestSpin = 1.0;

/// A rotation about a random axis by `least` to `most` rounds per second.
Spin drawSpin(Draws& draws, double least, double most);

/// Paints a ball of the stage: what is painted where is drawn.
void paintBall(simulation::StageBody& ball, BallPattern pattern, const Spin& spin, Draws& draws);

} // namespace dewpoint::experiment::scenarios
