// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Finger radius of an adult, meters. Typical values are 8 to 9.5 mm.
inline constexpr double kFingerRadius = 0.009;

/// Grip of a hand on a ball. Angles are in radians, lengths in meters.
struct Grip {
  /// Unit vector from the ball's center to the palm.
  Eigen::Vector3d palm = Eigen::Vector3d::UnitX();
  /// Unit vector perpendicular to `palm`, toward the fingers.
  Eigen::Vector3d fingers = Eigen::Vector3d::UnitY();
  double reachAngle = 1.8;   ///< angle at the ball's center from the palm to the fingertips
  double spreadAngle = 0.47; ///< angle about the `palm` axis from one finger to the next
  double fingerRadius = kFingerRadius;
  /// Returns the unit vector from the palm along the forearm.
  Eigen::Vector3d forearmDirection() const { return (0.8 * palm - 0.6 * fingers).normalized(); }
};

/// Returns a hand around a ball of radius `ballRadius` (meters): four fingers and the thumb on the
/// surface of the ball, the palm and the forearm. Positions are relative to the ball's center,
/// along the world axes. `color` is BGR in full light.
std::vector<MovingPart> grippingHand(const Grip& grip, double ballRadius, const Vector3f& color);

/// Returns a hand between open and closed: `closed` = 0 gives a flat hand with straight fingers,
/// and 1 gives a fist. The palm is at the origin, in the plane of X (toward the fingertips) and Y
/// (toward the thumb). All parts are marked as belonging to the target.
std::vector<MovingPart> partlyClosedHand(double closed, const Vector3f& color);

/// Skin color of hands in the room, BGR in full light.
inline const Vector3f kSkinColor = rgb(222, 168, 134);

} // namespace dewpoint::simulation
