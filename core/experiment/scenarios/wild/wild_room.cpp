// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/wild/wild_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::Material;
using simulation::Pattern;
using simulation::Shape;
using simulation::Vector3f;

// What is in a room is chosen, unless a line says why: for rooms as different as homes are.

/// Share of the clutter and of the walls that has the target's color; twice as many posters and
/// shirts do. So about every second run has several such things.
constexpr double kTargetColored = 0.15;
/// How much of full light the target's color has on other things: paint is seldom quite the same.
constexpr double kDarkestTone = 0.7;
/// Gray levels of other colors: neither black nor cut at full scale.
constexpr double kDarkestChannel = 25.0;
constexpr double kLightestChannel = 235.0;
/// The darkest that a channel of a wall's paint is, gray levels.
constexpr double kDarkestWall = 120.0;
/// Pieces of clutter; some find no position.
constexpr int kLeastClutter = 8;
constexpr int kMostClutter = 20;
/// The least half size of a piece of clutter, of the largest.
constexpr double kLeastSize = 0.15;
/// A poster's middle is this far before its wall, meters.
constexpr float kPosterBefore = 0.015F;
/// How far people walk from the origin, meters: beyond the desk and the cameras, before the walls.
constexpr double kPeopleAway = 1.75;
constexpr int kMostPeople = 3;

/// The part of a room that clutter stands in. World, meters. On the desk: the desk's top (see
/// furnishDesk()); in the hall: to its walls.
struct Ground {
  Eigen::Vector2d middle;
  double half = 0.7;  ///< to the sides
  double clear = 0.2; ///< nothing stands nearer to the middle or to a camera
  double size = 0.06; ///< half size of the largest objects
};

Ground groundOf(simulation::Furnishing furnishing) {
  if (furnishing == simulation::Furnishing::Hall) {
    return {{0.0, 0.0}, 2.1, 0.9, 0.25};
  }
  return {{0.47, 0.47}, 0.7, 0.2, 0.06};
}

bool chance(double share, RandomDraws& draws) {
  return draws.drawUniform(0.0, 1.0) < share;
}

/// BGR: any color, or at times that of the target, or that a little darker.
Vector3f drawColor(double targetColored, const Eigen::Vector3d& target, RandomDraws& draws) {
  if (chance(targetColored, draws)) {
    const double tone = draws.drawUniform(kDarkestTone, 1.0);
    return (tone * target).cast<float>();
  }
  const Eigen::Vector3d color = draws.drawPointInBox(Eigen::Vector3d::Constant(kDarkestChannel),
                                                     Eigen::Vector3d::Constant(kLightestChannel));
  return color.cast<float>();
}

Material drawMaterial(const Eigen::Vector3d& target, RandomDraws& draws) {
  constexpr std::array kPatterns{Pattern::Plain, Pattern::Plain, Pattern::Wood, Pattern::Plaster,
                                 Pattern::Skin};
  const auto pattern = static_cast<std::size_t>(draws.drawInteger(0, 4));
  return {kPatterns.at(pattern), drawColor(kTargetColored, target, draws)};
}

/// A position on the ground; nothing when the drawn one is taken.
std::optional<Eigen::Vector2d> drawSpot(const Ground& ground, const CameraRig& rig,
                                        RandomDraws& draws) {
  const Eigen::Vector3d half{ground.half, ground.half, 0.0};
  const Eigen::Vector2d spot = ground.middle + draws.drawPointInBox(-half, half).head<2>();
  const auto near = [&](const Camera& camera) {
    return (camera.center().head<2>() - spot).norm() < ground.clear;
  };
  const bool taken = (spot - ground.middle).norm() < ground.clear || std::ranges::any_of(rig, near);
  return taken ? std::nullopt : std::optional(spot);
}

void addClutter(const Ground& ground, const CameraRig& rig, const Eigen::Vector3d& target,
                RandomDraws& draws, simulation::Furniture& furniture) {
  constexpr std::array kShapes{Shape::Box, Shape::Ellipsoid, Shape::Cylinder};
  const int count = draws.drawInteger(kLeastClutter, kMostClutter);
  for (int i = 0; i < count; ++i) {
    const auto spot = drawSpot(ground, rig, draws);
    const Eigen::Vector3d half =
        draws.drawPointInBox(Eigen::Vector3d::Constant(kLeastSize), Eigen::Vector3d::Ones()) *
        ground.size;
    const auto shape = kShapes.at(static_cast<std::size_t>(draws.drawInteger(0, 2)));
    const Material material = drawMaterial(target, draws);
    const double yaw = draws.drawUniform(0.0, kFullTurn);
    if (!spot) {
      continue;
    }
    Vector3f size = half.cast<float>();
    if (shape == Shape::Cylinder) {
      size.y() = size.x(); // round
    }
    const Eigen::Vector2f at = spot->cast<float>();
    furniture.add(shape, {at.x(), at.y(), size.z()}, size, material, static_cast<float>(yaw));
  }
}

/// Posters on the two walls that the demo's cameras face; sizes and positions in meters.
void addPosters(simulation::Furnishing furnishing, const Eigen::Vector3d& target,
                RandomDraws& draws, simulation::Furniture& furniture) {
  const bool hall = furnishing == simulation::Furnishing::Hall;
  const float wall = hall ? simulation::kHallHalfSize
                          : simulation::kDeskRoomCenter + simulation::kDeskRoomHalfSize;
  for (const bool alongX : {true, false}) {
    const auto along = static_cast<float>(draws.drawUniform(-1.0, 1.8));
    const auto up = static_cast<float>(draws.drawUniform(0.3, 1.3));
    const auto wide = static_cast<float>(draws.drawUniform(0.1, 0.5));
    const auto tall = static_cast<float>(draws.drawUniform(0.1, 0.4));
    const Material paper{Pattern::Plain, drawColor(2.0 * kTargetColored, target, draws)};
    if (alongX) {
      furniture.add(Shape::Box, {along, wall - kPosterBefore, up}, {wide, 0.01F, tall}, paper);
    } else {
      furniture.add(Shape::Box, {wall - kPosterBefore, along, up}, {0.01F, wide, tall}, paper);
    }
  }
}

} // namespace

simulation::RoomDesign randomRoom(simulation::Furnishing furnishing, const CameraRig& rig,
                                  RandomDraws& draws, const Eigen::Vector3d& targetColor) {
  simulation::RoomDesign design;
  const Ground ground = groundOf(furnishing);
  addClutter(ground, rig, targetColor, draws, design.additionalFurniture);
  addPosters(furnishing, targetColor, draws, design.additionalFurniture);
  const Eigen::Vector3d paint = draws.drawPointInBox(Eigen::Vector3d::Constant(kDarkestWall),
                                                     Eigen::Vector3d::Constant(kLightestChannel));
  const Vector3f likeTarget = drawColor(1.0, targetColor, draws);
  const bool pink = chance(kTargetColored, draws);
  design.wallMaterial =
      Material{Pattern::Plaster, pink ? likeTarget : Vector3f(paint.cast<float>())};
  // From the middle of the ground, meters: below the ceilings, above what stands there.
  const Eigen::Vector3d lamp = draws.drawPointInBox({-0.8, -0.8, 1.3}, {0.8, 0.8, 1.9});
  const Vector3f middle{static_cast<float>(ground.middle.x()),
                        static_cast<float>(ground.middle.y()), 0.0F};
  design.lampPosition = middle + lamp.cast<float>();
  return design;
}

std::vector<simulation::Walker> randomPeople(simulation::Furnishing furnishing, double seconds,
                                             RandomDraws& draws,
                                             const Eigen::Vector3d& targetColor) {
  std::vector<simulation::Walker> people;
  if (furnishing == simulation::Furnishing::Hall) {
    return people;
  }
  const int count = draws.drawInteger(0, kMostPeople);
  for (int i = 0; i < count; ++i) {
    simulation::Walker walker;
    walker.name = fmt::format("passer-by {}", i + 1);
    walker.height = draws.drawUniform(1.5, 1.95); // adults, meters
    walker.clothes.shirt = drawColor(2.0 * kTargetColored, targetColor, draws);
    walker.clothes.trousers = drawColor(0.0, targetColor, draws);
    const bool alongX = draws.flipCoin();
    // Along the wall, meters.
    const double from = draws.drawUniform(-1.0, 1.9);
    const double to = draws.drawUniform(-1.0, 1.9);
    const auto at = [&](double along) -> Eigen::Vector2d {
      return alongX ? Eigen::Vector2d(along, kPeopleAway) : Eigen::Vector2d(kPeopleAway, along);
    };
    walker.waypoints = {{0.0, at(from)}, {std::max(1.0, seconds), at(to)}};
    people.push_back(walker);
  }
  return people;
}

float floorHeightOf(simulation::Furnishing furnishing) {
  const bool desk = furnishing == simulation::Furnishing::Desk ||
                    furnishing == simulation::Furnishing::ClutteredDesk;
  return desk ? -simulation::kDeskHeight : 0.0F; // the desk's top is z = 0
}

} // namespace dewpoint::experiment::scenarios
