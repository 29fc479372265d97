// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Where a piece of furniture is to stand at a time: seconds; world x and y, meters; radians about
/// the vertical.
struct FurniturePosition {
  double time = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double yaw = 0.0;
};

/// A piece of furniture that people move. It is drawn with them, not with the room at rest, so that
/// what was behind it comes to light.
struct MovableFurniture {
  /// Its parts around the point of the floor below its center, x forward and z up, meters.
  std::vector<BodyPart> parts;
  /// In the order of times, at least one: it stands at the first before its time and at the last
  /// after its, and glides from one to the next in between.
  std::vector<FurniturePosition> way;
  double reach = 0.3; ///< radius of a circle on the floor around all of it, meters

  FurniturePosition at(double time) const;
};

/// The parts of a piece of furniture in the world at a time; they are of no body.
std::vector<BodyPart> furnitureParts(const MovableFurniture& furniture, double time);

/// A seat on a foot; `height` of the seat in meters.
MovableFurniture makeStool(double height);
/// A closed cabinet on the floor; half sizes in meters, `color` BGR in full light.
MovableFurniture makeCabinet(const Vector3f& halfSize, const Vector3f& color);

} // namespace dewpoint::simulation
