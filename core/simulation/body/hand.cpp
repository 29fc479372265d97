// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/hand.h"

#include "core/simulation/body/part_shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dewpoint::simulation {
namespace {

// Sizes of an adult's hand in meters, rounded from our own hands.
constexpr double kPalmThick = 0.012;     ///< half
constexpr double kPalmWide = 0.04;       ///< half
constexpr double kPalmLong = 0.048;      ///< half
constexpr double kForearmRadius = 0.026; ///< near the wrist
constexpr double kForearmLong = 0.22;

/// Where a finger around a ball begins, as an angle from the palm, radians; chosen by eye.
constexpr double kKnuckle = 0.5;
constexpr int kFingerParts = 3; ///< straight pieces: a finger has three bones

} // namespace

std::vector<MovingPart> grippingHand(const Grip& grip, double ballRadius, const Vector3f& color) {
  const Eigen::Vector3d across = grip.palm.cross(grip.fingers);
  const double middle = ballRadius + grip.fingerRadius; // from the ball's center to a finger's axis
  std::vector<MovingPart> parts;
  const auto addFinger = [&](double azimuth, double reach) {
    const Eigen::Vector3d side = std::cos(azimuth) * grip.fingers + std::sin(azimuth) * across;
    const auto at = [&](int joint) -> Eigen::Vector3d {
      const double angle = kKnuckle + (reach - kKnuckle) * joint / kFingerParts;
      return middle * (std::cos(angle) * grip.palm + std::sin(angle) * side);
    };
    for (int k = 0; k < kFingerParts; ++k) {
      parts.push_back(capsuleBetween(at(k), at(k + 1), grip.fingerRadius, color));
    }
  };
  for (const double finger : {-1.5, -0.5, 0.5, 1.5}) {
    addFinger(finger * grip.spreadAngle, grip.reachAngle * (1.0 - 0.06 * std::abs(finger)));
  }
  addFinger(std::numbers::pi, 0.85 * grip.reachAngle); // the thumb, opposite
  MovingPart palm =
      ellipsoidAt((ballRadius + kPalmThick) * grip.palm, {kPalmThick, kPalmWide, kPalmWide}, color);
  palm.axes.row(0) = grip.palm.cast<float>();
  palm.axes.row(1) = grip.fingers.cast<float>();
  palm.axes.row(2) = across.cast<float>();
  parts.push_back(palm);
  const Eigen::Vector3d wrist = (ballRadius + 0.02) * grip.palm;
  parts.push_back(
      capsuleBetween(wrist, wrist + kForearmLong * grip.forearmDirection(), kForearmRadius, color));
  return parts;
}

std::vector<MovingPart> partlyClosedHand(double closed, const Vector3f& color) {
  // Lengths of a finger's three bones, and how far each joint bends in a fist, in radians.
  constexpr std::array<double, 3> kBones{0.045, 0.028, 0.022};
  constexpr std::array<double, 3> kBends{1.4, 1.6, 1.0};
  std::vector<MovingPart> parts;
  parts.push_back(
      ellipsoidAt(Eigen::Vector3d::Zero(), {kPalmLong, kPalmWide, kPalmThick + 0.003}, color));
  const auto addFinger = [&](const Eigen::Vector3d& knuckle, const Eigen::Vector3d& straight,
                             const Eigen::Vector3d& inwards, double length, double bend) {
    Eigen::Vector3d joint = knuckle;
    double angle = 0.0;
    for (std::size_t k = 0; k < kBones.size(); ++k) {
      angle += bend * closed * kBends.at(k);
      const Eigen::Vector3d along = std::cos(angle) * straight + std::sin(angle) * inwards;
      const Eigen::Vector3d next = joint + length * kBones.at(k) * along;
      parts.push_back(capsuleBetween(joint, next, kFingerRadius, color));
      joint = next;
    }
  };
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ(); // fingers bend towards the palm's side
  for (const double finger : {-1.5, -0.5, 0.5, 1.5}) {
    // They part a little when the hand opens.
    const double fan = 0.12 * finger * (1.0 - closed);
    const Eigen::Vector3d straight{std::cos(fan), std::sin(fan), 0.0};
    const Eigen::Vector3d knuckle{0.9 * kPalmLong, 0.02 * finger, 0.0};
    addFinger(knuckle, straight, down, 1.0 - 0.08 * std::abs(finger), 1.0);
  }
  // The thumb bends across the palm; `inwards` is square to it.
  const Eigen::Vector3d thumb{0.6, 0.8, 0.0};
  const Eigen::Vector3d across = (down + Eigen::Vector3d(0.56, -0.42, 0.0)).normalized();
  addFinger({-0.01, 0.9 * kPalmWide, 0.0}, thumb, across, 0.85, 0.7);
  for (MovingPart& part : parts) {
    part.belongsToTarget = true;
  }
  return parts;
}

} // namespace dewpoint::simulation
