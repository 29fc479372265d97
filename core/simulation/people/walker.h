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

/// Position of a walker (world x and y, meters) at a time (seconds).
struct Waypoint {
  double time = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
};

/// Clothes of a walker; BGR in full light, [0, 255].
struct Clothes {
  Vector3f shirt = rgb(60, 90, 170);
  Vector3f trousers = rgb(60, 62, 74);
  Vector3f hair = rgb(52, 38, 30);
  Vector3f skin = rgb(222, 172, 142);
  Cloth shirtCloth; ///< pattern of the shirt; its first color is `shirt`
};

/// Object carried by a walker.
struct CarriedObject {
  enum class Kind {
    Box, ///< held in front of the chest with both arms
    Bag, ///< hangs from the right hand
  };
  Kind kind = Kind::Box;
  Vector3f halfSize{0.15F, 0.2F, 0.15F}; ///< half sizes: forward, left, up; meters
  Vector3f color = rgb(168, 132, 92);
};

/// Height in meters of the reference body, an adult. Bodies of other heights are scaled from the
/// reference body.
inline constexpr double kReferenceHeight = 1.75;

/// Simulated person who walks from waypoint to waypoint.
struct Walker {
  std::string name;
  double height = kReferenceHeight; ///< meters
  Clothes clothes;
  std::vector<Waypoint> waypoints;
  std::vector<PostureChange> postures; ///< in order of time; empty: always standing
  std::optional<CarriedObject> carriedObject;
  /// Time from which on the person is present, seconds.
  double presentFrom = -std::numeric_limits<double>::infinity();
  /// Time from which on the person is no longer present, seconds.
  double presentUntil = std::numeric_limits<double>::infinity();

  bool isPresentAt(double time) const { return time >= presentFrom && time < presentUntil; }
  /// Returns the point on the floor (world x and y, meters) below the center of the body at a time
  /// (seconds). The point lies on the path through the waypoints, whose corners are rounded.
  Eigen::Vector2d positionAt(double time) const;
  /// Returns the height of the top of the head above the floor, in meters, at a time in seconds.
  /// The result is `height` for a standing person.
  double topHeightAt(double time) const;
};

/// Height of an adult's head as a fraction of the body height: 0.25 m of 1.75 m. Drawing manuals
/// give a seventh to an eighth.
inline constexpr double kAdultHeadHeightFraction = 1.0 / 7.0;
/// Body height in meters below which a body has the proportions of a child: about the height of a
/// 13-year-old.
inline constexpr double kAdultHeight = 1.6;

/// Returns the height of the head as a fraction of the body height `height` (meters). The fraction
/// is kAdultHeadHeightFraction for heights of at least kAdultHeight. For smaller bodies, the
/// fraction increases linearly with decreasing height, up to 0.19 at 0.9 m and below. According to
/// drawing manuals, the head of a small child is about a fifth of the child's height.
double headHeightFraction(double height);

/// Returns the height of a seat (meters) that fits a person of this `height` (meters).
double seatHeight(double height);

/// Shape of a part of a body.
enum class PartShape { Ellipsoid, Box };

/// Part of a body, of a carried object or of furniture: an ellipsoid or a box of any orientation.
struct BodyPart {
  Vector3f center;   ///< world frame, meters
  Vector3f halfSize; ///< semi-axes along the part's own axes, meters
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< the part's axes in the world, as rows
  Vector3f color;                                     ///< BGR in full light
  PartShape shape = PartShape::Ellipsoid;
  /// True for a part of a body. False for a part of a carried object or of furniture, which can
  /// hide bodies but does not belong to a silhouette.
  bool belongsToBody = true;
  Cloth cloth = {};
};

/// Returns the parts of a walker at a time (seconds), in the world frame: head, hair, trunk, arms
/// and legs, followed by the carried object if there is one. Arms and legs swing with the steps.
std::vector<BodyPart> bodyParts(const Walker& walker, double time);

} // namespace dewpoint::simulation
