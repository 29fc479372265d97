// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/posture.h"
#include "core/simulation/room/room.h"
#include "core/simulation/surface/cloth.h"

#include <Eigen/Core>

#include <limits>
#include <optional>
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
  Cloth shirtCloth; ///< what is on the shirt beside its color
};

/// What a walker carries, and how.
struct Load {
  enum class Kind {
    Box, ///< before the chest, with both arms
    Bag, ///< hangs from the right hand
  };
  Kind kind = Kind::Box;
  Vector3f halfSize{0.15F, 0.2F, 0.15F}; ///< forward, left, up; meters
  Vector3f color = rgb(168, 132, 92);
};

/// Height of the body that all others are scaled from, meters; chosen: an adult's.
inline constexpr double kReferenceHeight = 1.75;

/// A person of the simulation, who goes from waypoint to waypoint.
struct Walker {
  std::string name;
  double height = kReferenceHeight; ///< meters
  Clothes clothes;
  std::vector<Waypoint> way;
  std::vector<PostureChange> postures; ///< in the order of their times; none: always stands
  std::optional<Load> load;
  double from = -std::numeric_limits<double>::infinity(); ///< is there from this time on, seconds
  double until = std::numeric_limits<double>::infinity(); ///< and before this one

  bool presentAt(double time) const { return time >= from && time < until; }
  /// The point of the floor below the center of the body: the way with its corners rounded off.
  Eigen::Vector2d position(double time) const;
  /// How high the top of the head is above the floor, meters: `height` for somebody who stands.
  double top(double time) const;
};

/// Height of an adult's head as a part of the height: 0.25 m of 1.75 m; drawing books say a seventh
/// to an eighth.
inline constexpr double kAdultHeadShare = 1.0 / 7.0;
/// Up to this height a body has a child's proportions, meters; chosen: about that of a child of 13.
inline constexpr double kAdultHeight = 1.6;

/// Height of the head as a part of the height: an adult's from kAdultHeight on, and growing evenly
/// below it to 0.19 of the height at 0.9 m and less. Chosen, near the drawing rule that the
/// head of a small child is about a fifth of its height.
double headShare(double height);

/// How high a seat is that fits a person of `height`, meters.
double seatHeight(double height);

enum class PartShape { Ellipsoid, Box };

/// A part of a body, of a load or of furniture: an ellipsoid or a box of any orientation.
struct BodyPart {
  Vector3f center;                                    ///< world, meters
  Vector3f halfSize;                                  ///< semi-axes along its own axes, meters
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< rows: its own axes in the world
  Vector3f color;                                     ///< BGR in full light
  PartShape shape = PartShape::Ellipsoid;
  bool ofBody = true; ///< false: a load or furniture, which hides bodies and is no silhouette
  Cloth cloth = {};
};

/// Head, hair, trunk, arms and legs at a time, then the load; the limbs swing with the steps.
std::vector<BodyPart> bodyParts(const Walker& walker, double time);

} // namespace dewpoint::simulation
