// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/wild_office.h"

#include <algorithm>
#include <cstddef>

namespace dewpoint::experiment {
namespace {

using simulation::Material;
using simulation::Pattern;
using simulation::Shape;
using simulation::Vector3f;

// What is in a room is chosen, unless a line says why: for offices as different as they are.

/// Cameras and lamps are within this of the middle along x and y, meters: before the walls.
constexpr double kMostAside = simulation::kOfficeHalfSize - 0.15;
/// Share of the posters that has the color of a shirt.
constexpr double kLikeAShirt = 0.5;
/// The darkest that a channel of a wall's paint is, and the range of other colors; gray levels.
constexpr double kDarkestPaint = 120.0;
constexpr double kDarkestPoster = 25.0;
constexpr double kLightest = 235.0;

Camera putUpElsewhere(Camera camera, RandomDraws& draws) {
  constexpr double kMovedAside = 0.6; // meters along x and y, either way
  constexpr double kAim = 0.3;        // meters along each axis, either way
  constexpr double kRoll = 0.1;       // radians, either way
  constexpr double kLowest = 1.9;     // meters: on a cupboard
  constexpr double kHighest = 2.55;   // meters: below the ceiling
  constexpr double kShortest = 0.8;   // of the focal length: 82 degrees across
  constexpr double kLongest = 1.15;   // 62 degrees
  Eigen::Vector3d center = camera.center();
  for (int axis = 0; axis < 2; ++axis) {
    center[axis] = std::clamp(center[axis] + draws.drawUniform(-kMovedAside, kMovedAside),
                              -kMostAside, kMostAside);
  }
  center.z() = draws.drawUniform(kLowest, kHighest);
  const Eigen::Vector3d aim = Eigen::Vector3d::Constant(kAim);
  const Eigen::Vector3d target = Eigen::Vector3d(0.0, 0.0, 0.8) + draws.drawPointInBox(-aim, aim);
  camera.cameraFromWorld =
      lookAt(center, target, Eigen::Vector3d::UnitZ(), draws.drawUniform(-kRoll, kRoll));
  const double focal = draws.drawUniform(kShortest, kLongest);
  camera.intrinsics.focalX *= focal;
  camera.intrinsics.focalY *= focal;
  return camera;
}

Vector3f drawPosterColor(const OfficeScene& scene, RandomDraws& draws) {
  const bool shirt = draws.drawUniform(0.0, 1.0) < kLikeAShirt;
  const Eigen::Vector3d other = draws.drawPointInBox(Eigen::Vector3d::Constant(kDarkestPoster),
                                                     Eigen::Vector3d::Constant(kLightest));
  if (shirt && !scene.people.empty()) {
    const int who = draws.drawInteger(0, static_cast<int>(scene.people.size()) - 1);
    return scene.people[static_cast<std::size_t>(who)].clothes.shirt;
  }
  return other.cast<float>();
}

/// A poster on each wall, flat upon it; sizes and positions in meters.
void hangPosters(const OfficeScene& scene, RandomDraws& draws, simulation::Furniture& furniture) {
  constexpr float kBefore = 0.02F; // its middle, from the wall
  constexpr float kThick = 0.01F;  // half of it
  for (const bool alongX : {true, false}) {
    for (const float side : {-1.0F, 1.0F}) {
      const auto along = static_cast<float>(draws.drawUniform(-2.0, 2.0));
      const auto up = static_cast<float>(draws.drawUniform(1.2, 1.8));
      const auto wide = static_cast<float>(draws.drawUniform(0.2, 0.7));
      const auto tall = static_cast<float>(draws.drawUniform(0.2, 0.6));
      const float wall = side * (simulation::kOfficeHalfSize - kBefore);
      const Material paper{Pattern::Plain, drawPosterColor(scene, draws)};
      if (alongX) {
        furniture.add(Shape::Box, {along, wall, up}, {wide, kThick, tall}, paper);
      } else {
        furniture.add(Shape::Box, {wall, along, up}, {kThick, wide, tall}, paper);
      }
    }
  }
}

} // namespace

WildOffice makeWildOffice(const OfficeScene& scene, RandomDraws& draws) {
  WildOffice office;
  for (const Camera& camera : scene.cameras) {
    office.rig.push_back(putUpElsewhere(camera, draws));
  }
  hangPosters(scene, draws, office.design.additionalFurniture);
  const Eigen::Vector3d paint = draws.drawPointInBox(Eigen::Vector3d::Constant(kDarkestPaint),
                                                     Eigen::Vector3d::Constant(kLightest));
  office.design.wallMaterial = Material{Pattern::Plaster, paint.cast<float>()};
  // Above the heads, below the ceiling, over the part of the floor that people walk on.
  const Eigen::Vector3d lamp = draws.drawPointInBox({-1.5, -1.5, 2.3}, {1.5, 1.5, 2.6});
  office.design.lampPosition = lamp.cast<float>();
  return office;
}

} // namespace dewpoint::experiment
