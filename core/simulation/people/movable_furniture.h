// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Pose of a piece of furniture at a time (seconds): position in world x and y (meters), and
/// rotation angle `yaw` about the vertical (radians).
struct FurniturePose {
  double time = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double yaw = 0.0;
};

/// Piece of furniture that people move. The furniture is drawn with the people and not with the
/// room at rest, so that the background becomes visible where the furniture was.
struct MovableFurniture {
  /// Parts relative to the point on the floor below the center of the furniture, x forward and z
  /// up, meters.
  std::vector<BodyPart> parts;
  /// Poses in order of time; there must be at least one. The furniture moves smoothly from each
  /// pose to the next. Before the time of the first pose, it stays at the first pose. After the
  /// time of the last pose, it stays at the last pose.
  std::vector<FurniturePose> waypoints;
  double enclosingRadius =
      0.3; ///< radius of a circle on the floor that encloses the furniture, meters

  /// Returns the pose at a time in seconds.
  FurniturePose poseAt(double time) const;
};

/// Returns the parts of a piece of furniture at a time (seconds), in the world frame.
/// BodyPart::belongsToBody is false for all these parts.
std::vector<BodyPart> furnitureParts(const MovableFurniture& furniture, double time);

/// Returns a stool: a seat on a single foot. `height` is the height of the seat in meters.
MovableFurniture makeStool(double height);
/// Returns a closed cabinet on the floor. Half sizes are in meters, and `color` is BGR in full
/// light.
MovableFurniture makeCabinet(const Vector3f& halfSize, const Vector3f& color);

} // namespace dewpoint::simulation
