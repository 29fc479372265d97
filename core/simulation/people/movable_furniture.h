// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Position of a piece of furniture at a time: seconds; world x and y, meters; angle about the
/// vertical, radians.
struct FurniturePosition {
  double time = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double yaw = 0.0;
};

/// A piece of furniture that people move. It is drawn with the people, not with the room at rest,
/// so what was behind it becomes visible.
struct MovableFurniture {
  /// Parts relative to the point on the floor below its center, x forward and z up, meters.
  std::vector<BodyPart> parts;
  /// Positions in order of time, at least one. The furniture stays at the first before its time and
  /// at the last after its time, and moves smoothly between them.
  std::vector<FurniturePosition> way;
  double reach = 0.3; ///< radius of a circle on the floor that encloses it, meters

  /// Returns the position at a time in seconds.
  FurniturePosition at(double time) const;
};

/// Returns the parts of a piece of furniture in the world frame at a time; they do not belong to a
/// body.
std::vector<BodyPart> furnitureParts(const MovableFurniture& furniture, double time);

/// Returns a seat on a foot; `height` of the seat in meters.
MovableFurniture makeStool(double height);
/// Returns a closed cabinet on the floor; half sizes in meters, `color` BGR in full light.
MovableFurniture makeCabinet(const Vector3f& halfSize, const Vector3f& color);

} // namespace dewpoint::simulation
