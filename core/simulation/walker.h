// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room.h"

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace dewpoint::simulation {

/// Where a walker is to be at a time. Seconds; world x and y, meters.
struct Waypoint {
  double time = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
};

/// What a walker wears; BGR in full light, [0, 255].
struct Clothes {
  Vector3f shirt = rgb(60, 90, 170);
  Vector3f trousers = rgb(60, 62, 74);
  Vector3f hair = rgb(52, 38, 30);
  Vector3f skin = rgb(222, 172, 142);
};

/// A person of the simulation, who goes from waypoint to waypoint.
struct Walker {
  std::string name;
  double height = 1.75; ///< meters
  Clothes clothes;
  std::vector<Waypoint> way;
  double from = -std::numeric_limits<double>::infinity(); ///< is there from this time on, seconds
  double until = std::numeric_limits<double>::infinity(); ///< and before this one

  bool presentAt(double time) const { return time >= from && time < until; }
  /// The point of the floor below the middle of the body: the way with its corners rounded off.
  Eigen::Vector2d position(double time) const;
};

/// A part of a body: an ellipsoid of any orientation.
struct BodyPart {
  Vector3f center;                                    ///< world, meters
  Vector3f halfSize;                                  ///< semi-axes along its own axes, meters
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< rows: its own axes in the world
  Vector3f color;                                     ///< BGR in full light
};

/// Head, hair, trunk, arms and legs at a time; the limbs swing with the steps.
std::vector<BodyPart> bodyParts(const Walker& walker, double time);

} // namespace dewpoint::simulation
