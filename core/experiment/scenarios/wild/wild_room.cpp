// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/wild/wild_room.h"

#include "core/simulation/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::Material;
using simulation::Pattern;
using simulation::Shape;
using simulation::Vector3f;

/// Share of the clutter that has the target's color, and of walls and shirts.
constexpr double kTargetColored = 0.15;

/// The part of a room that clutter stands in. World, meters.
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

bool chance(double share, Draws& draws) {
  return draws.uniform(0.0, 1.0) < share;
}

/// BGR: any color, or at times that of the target, a little lighter or darker.
Vector3f drawColor(double targetColored, Draws& draws) {
  if (chance(targetColored, draws)) {
    const double tone = draws.uniform(0.7, 1.0);
    return (tone * simulation::SceneBall().color).cast<float>();
  }
  const Eigen::Vector3d color =
      draws.inBox(Eigen::Vector3d::Constant(25.0), Eigen::Vector3d::Constant(235.0));
  return color.cast<float>();
}

Material drawMaterial(Draws& draws) {
  constexpr std::array kPatterns{Pattern::Plain, Pattern::Plain, Pattern::Wood, Pattern::Plaster,
                                 Pattern::Skin};
  const auto pattern = static_cast<std::size_t>(draws.whole(0, 4));
  return {kPatterns.at(pattern), drawColor(kTargetColored, draws)};
}

/// A position on the ground; nothing when the drawn one is taken.
std::optional<Eigen::Vector2d> drawSpot(const Ground& ground, const CameraRig& rig, Draws& draws) {
  const Eigen::Vector3d half{ground.half, ground.half, 0.0};
  const Eigen::Vector2d spot = ground.middle + draws.inBox(-half, half).head<2>();
  const auto near = [&](const Camera& camera) {
    return (camera.center().head<2>() - spot).norm() < ground.clear;
  };
  const bool taken = (spot - ground.middle).norm() < ground.clear || std::ranges::any_of(rig, near);
  return taken ? std::nullopt : std::optional(spot);
}

void addClutter(const Ground& ground, const CameraRig& rig, Draws& draws,
                simulation::Furniture& furniture) {
  constexpr std::array kShapes{Shape::Box, Shape::Ellipsoid, Shape::Cylinder};
  const int count = draws.whole(8, 20);
  for (int i = 0; i < count; ++i) {
    const auto spot = drawSpot(ground, rig, draws);
    const Eigen::Vector3d half =
        draws.inBox(Eigen::Vector3d::Constant(0.15), Eigen::Vector3d::Ones()) * ground.size;
    const auto shape = kShapes.at(static_cast<std::size_t>(draws.whole(0, 2)));
    const Material material = drawMaterial(draws);
    const double yaw = draws.uniform(0.0, kFullTurn);
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

/// Posters on the two walls that the demo's cameras face.
void addPosters(simulation::Furnishing furnishing, Draws& draws, simulation::Furniture& furniture) {
  const float wall = furnishing == simulation::Furnishing::Hall ? 2.24F : 2.28F;
  for (const bool alongX : {true, false}) {
    const auto along = static_cast<float>(draws.uniform(-1.0, 1.8));
    const auto up = static_cast<float>(draws.uniform(0.3, 1.3));
    const auto wide = static_cast<float>(draws.uniform(0.1, 0.5));
    const auto tall = static_cast<float>(draws.uniform(0.1, 0.4));
    const Material paper{Pattern::Plain, drawColor(2.0 * kTargetColored, draws)};
    if (alongX) {
      furniture.add(Shape::Box, {along, wall, up}, {wide, 0.01F, tall}, paper);
    } else {
      furniture.add(Shape::Box, {wall, along, up}, {0.01F, wide, tall}, paper);
    }
  }
}

} // namespace

simulation::RoomDesign drawRoom(simulation::Furnishing furnishing, const CameraRig& rig,
                                Draws& draws) {
  simulation::RoomDesign design;
  const Ground ground = groundOf(furnishing);
  addClutter(ground, rig, draws, design.further);
  addPosters(furnishing, draws, design.further);
  const Eigen::Vector3d paint =
      draws.inBox(Eigen::Vector3d::Constant(120.0), Eigen::Vector3d::Constant(235.0));
  const Vector3f targetColor = drawColor(1.0, draws);
  const bool pink = chance(kTargetColored, draws);
  design.walls = Material{Pattern::Plaster, pink ? targetColor : Vector3f(paint.cast<float>())};
  const Eigen::Vector3d lamp = draws.inBox({-0.8, -0.8, 1.3}, {0.8, 0.8, 1.9});
  const Vector3f middle{static_cast<float>(ground.middle.x()),
                        static_cast<float>(ground.middle.y()), 0.0F};
  design.lamp = middle + lamp.cast<float>();
  return design;
}

std::vector<simulation::Walker> drawPeople(simulation::Furnishing furnishing, double seconds,
                                           Draws& draws) {
  std::vector<simulation::Walker> people;
  if (furnishing == simulation::Furnishing::Hall) {
    return people;
  }
  constexpr double kAway = 1.75; // of their way from the origin, beyond the desk and the cameras
  const int count = draws.whole(0, 3);
  for (int i = 0; i < count; ++i) {
    simulation::Walker walker;
    walker.name = fmt::format("passer-by {}", i + 1);
    walker.height = draws.uniform(1.5, 1.95);
    walker.clothes.shirt = drawColor(2.0 * kTargetColored, draws);
    walker.clothes.trousers = drawColor(0.0, draws);
    const bool alongX = draws.coin();
    const double from = draws.uniform(-1.0, 1.9);
    const double to = draws.uniform(-1.0, 1.9);
    const auto at = [&](double along) -> Eigen::Vector2d {
      return alongX ? Eigen::Vector2d(along, kAway) : Eigen::Vector2d(kAway, along);
    };
    walker.way = {{0.0, at(from)}, {std::max(1.0, seconds), at(to)}};
    people.push_back(walker);
  }
  return people;
}

float floorOf(simulation::Furnishing furnishing) {
  const bool desk = furnishing == simulation::Furnishing::Desk ||
                    furnishing == simulation::Furnishing::ClutteredDesk;
  return desk ? -0.75F : 0.0F; // the desk's top is z = 0
}

} // namespace dewpoint::experiment::scenarios
