// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Radius of an adult's finger, meters: 8 to 9.5 mm.
inline constexpr double kFingerRadius = 0.009;

/// How a hand holds a ball. Angles in radians, lengths in meters.
struct Grip {
  Eigen::Vector3d palm = Eigen::Vector3d::UnitX();    ///< unit vector, ball's center to the palm
  Eigen::Vector3d fingers = Eigen::Vector3d::UnitY(); ///< unit vector across it, to the fingers
  double reach = 1.8;   ///< angle at the ball's center from the palm to the fingertips
  double spread = 0.47; ///< angle about `palm` from one finger to the next
  double fingerRadius = kFingerRadius;
  /// Unit vector from the palm along the forearm.
  Eigen::Vector3d forearm() const { return (0.8 * palm - 0.6 * fingers).normalized(); }
};

/// A hand around a ball of radius `ballRadius` at the origin: four fingers and the thumb on its
/// surface, the palm and the forearm. World axes, relative to the ball's center.
std::vector<MovingPart> grippingHand(const Grip& grip, double ballRadius, const Vector3f& color);

/// A hand that is open (0: flat, fingers straight) or closed (1: a fist), with its palm in the
/// plane of X (to the fingertips) and Y (to the thumb) and the origin in the palm. All parts are
/// marked as target.
std::vector<MovingPart> openingHand(double closed, const Vector3f& color);

/// Skin as that of the room's hands.
inline const Vector3f kSkinColor = rgb(222, 168, 134);

} // namespace dewpoint::simulation
