// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/patterned_ball.h"

#include "core/simulation/body/part_shapes.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::SurfacePattern;
using simulation::Vector3f;

/// Matte white and black paint, BGR in full light.
const Vector3f kWhite{235.0F, 235.0F, 235.0F};
const Vector3f kDark{40.0F, 40.0F, 40.0F};

Vector3f whiteOrDark(RandomDraws& draws) {
  return draws.flipCoin() ? kWhite : kDark;
}

/// Rows: three directions at right angles, anyhow.
Eigen::Matrix3d drawFrame(RandomDraws& draws) {
  const Eigen::Vector3d first = draws.drawDirection();
  const Eigen::Vector3d second =
      Eigen::AngleAxisd(draws.drawUniform(0.0, kFullTurn), first) * first.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame.row(0) = first;
  frame.row(1) = second;
  frame.row(2) = first.cross(second);
  return frame;
}

void addPatch(SurfacePattern& pattern, const Eigen::Vector3d& axis, double halfAngle,
              const Vector3f& color) {
  pattern.patches.push_back({axis.cast<float>(), static_cast<float>(std::cos(halfAngle)), color});
}

void addOnePatch(SurfacePattern& pattern, RandomDraws& draws) {
  // Half width in radii: a patch of 22 to 32 mm on a ball of 35 mm, a label.
  constexpr double kLeast = 11.0 / 35.0;
  constexpr double kMost = 16.0 / 35.0;
  const double halfAngle = std::asin(draws.drawUniform(kLeast, kMost));
  addPatch(pattern, draws.drawDirection(), halfAngle, whiteOrDark(draws));
}

/// Evenly around a great circle.
void addLargePatches(SurfacePattern& pattern, int count, RandomDraws& draws) {
  const Eigen::Matrix3d frame = drawFrame(draws);
  const Vector3f color = whiteOrDark(draws);
  for (int k = 0; k < count; ++k) {
    const double angle = kFullTurn * k / count;
    const Eigen::Vector3d axis =
        std::cos(angle) * frame.row(0).transpose() + std::sin(angle) * frame.row(1).transpose();
    // Half angles in degrees: the panels of a beach ball.
    addPatch(pattern, axis, draws.drawUniform(35.0, 45.0) * kFullTurn / 360.0, color);
  }
}

void addSixSpots(SurfacePattern& pattern, RandomDraws& draws) {
  const Eigen::Matrix3d frame = drawFrame(draws);
  const Vector3f color = whiteOrDark(draws);
  const double halfAngle = draws.drawUniform(14.0, 18.0) * kFullTurn / 360.0; // of 14 to 18 degrees
  for (int axis = 0; axis < 3; ++axis) {
    addPatch(pattern, frame.row(axis).transpose(), halfAngle, color);
    addPatch(pattern, -frame.row(axis).transpose(), halfAngle, color);
  }
}

void addSeams(SurfacePattern& pattern, RandomDraws& draws) {
  const Eigen::Matrix3d frame = drawFrame(draws);
  const Vector3f color = whiteOrDark(draws);
  const auto sine = static_cast<float>(
      draws.drawUniform(2.5 / 35.0, 3.5 / 35.0)); // half width in radii: 5 to 7 mm
  for (const int axis : {0, 1}) {
    pattern.seams.push_back({frame.row(axis).transpose().cast<float>(), sine, color});
  }
}

void addOtherHalf(SurfacePattern& pattern, RandomDraws& draws) {
  const std::array<Vector3f, 4> colors{kWhite, kDark, simulation::rgb(40, 90, 210),
                                       simulation::rgb(240, 215, 50)};
  const Eigen::Vector3d axis = draws.drawDirection();
  addPatch(pattern, axis, 0.25 * kFullTurn,
           colors.at(static_cast<std::size_t>(draws.drawInteger(0, 3))));
}

SurfacePattern drawPattern(BallPattern kind, RandomDraws& draws) {
  SurfacePattern pattern;
  switch (kind) {
  case BallPattern::OnePatch:
    addOnePatch(pattern, draws);
    break;
  case BallPattern::TwoPatches:
    addLargePatches(pattern, 2, draws);
    break;
  case BallPattern::ThreePatches:
    addLargePatches(pattern, 3, draws);
    break;
  case BallPattern::SixSpots:
    addSixSpots(pattern, draws);
    break;
  case BallPattern::Seams:
    addSeams(pattern, draws);
    break;
  case BallPattern::TwoColors:
    addOtherHalf(pattern, draws);
    break;
  case BallPattern::Highlight:
    break;
  }
  return pattern;
}

/// Of lacquer: a highlight that is clipped where the cosine to its power exceeds about a half.
simulation::Gloss drawHighlight(RandomDraws& draws) {
  const auto peakLevel = static_cast<float>(draws.drawUniform(400.0, 600.0)); // gray levels
  const auto exponent = static_cast<float>(draws.drawUniform(20.0, 60.0));
  return {peakLevel, exponent};
}

} // namespace

Eigen::Matrix3f Spin::axesAt(double time) const {
  return Eigen::AngleAxisd(radiansPerSecond * time, axis)
      .toRotationMatrix()
      .transpose()
      .cast<float>();
}

Spin randomSpin(RandomDraws& draws, double least, double most) {
  const Eigen::Vector3d axis = draws.drawDirection();
  return {axis, kFullTurn * draws.drawUniform(least, most)};
}

void paintBall(simulation::StageBody& ball, BallPattern pattern, const Spin& spin,
               RandomDraws& draws) {
  simulation::MovingPart part = simulation::ballPart(ball.radius, ball.color.cast<float>());
  part.pattern = std::make_shared<const SurfacePattern>(drawPattern(pattern, draws));
  if (pattern == BallPattern::Highlight) {
    part.gloss = drawHighlight(draws);
  }
  ball.nominalRadius = ball.radius;
  ball.parts = [part, spin](double time) {
    simulation::MovingPart rotated = part;
    rotated.axes = spin.axesAt(time);
    return std::vector{std::move(rotated)};
  };
}

} // namespace dewpoint::experiment::scenarios
