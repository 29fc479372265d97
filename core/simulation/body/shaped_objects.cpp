// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/shaped_objects.h"

#include "core/simulation/body/hand.h"
#include "core/simulation/body/part_shapes.h"

namespace dewpoint::simulation {
namespace {

// All sizes in meters, rounded from things on our desks and from ourselves.

constexpr double kPlainForearmRadius = 0.03;

MovingPart asTarget(MovingPart part) {
  part.belongsToTarget = true;
  return part;
}

} // namespace

std::vector<MovingPart> capOnHead(const Vector3f& color) {
  return {
      asTarget(ellipsoidAt(Eigen::Vector3d::Zero(), {0.103, 0.088, 0.075}, color)), // crown
      asTarget(ellipsoidAt({0.12, 0.0, -0.02}, {0.06, 0.075, 0.007}, color)),       // peak
      ellipsoidAt({0.0, 0.0, -0.07}, {0.095, 0.08, 0.115}, kSkinColor),             // head
      capsuleBetween({-0.02, 0.0, -0.15}, {-0.02, 0.0, -0.4}, 0.055, kSkinColor),   // neck
  };
}

std::vector<MovingPart> glovedHand(double closed, const Vector3f& color) {
  std::vector<MovingPart> parts = partlyClosedHand(closed, color);
  parts.push_back(
      capsuleBetween({-0.06, 0.0, 0.0}, {-0.3, 0.0, 0.0}, kPlainForearmRadius, kSkinColor));
  return parts;
}

std::vector<MovingPart> sleevedArm(const Vector3f& color) {
  std::vector<MovingPart> parts{
      asTarget(frustumBetween({-0.12, 0.0, 0.0}, 0.055, {0.12, 0.0, 0.0}, 0.042, color))};
  for (MovingPart part : partlyClosedHand(0.3, kSkinColor)) {
    part.belongsToTarget = false;
    parts.push_back(movedPart(part, Eigen::Matrix3d::Identity(), {0.18, 0.0, 0.0}));
  }
  return parts;
}

std::vector<MovingPart> cone(const Vector3f& color) {
  return {asTarget(frustumBetween({0.0, 0.0, -0.09}, 0.06, {0.0, 0.0, 0.09}, 0.004, color))};
}

std::vector<MovingPart> stick(const Vector3f& color) {
  return {asTarget(capsuleBetween({-0.142, 0.0, 0.0}, {0.142, 0.0, 0.0}, 0.008, color))};
}

std::vector<MovingPart> computerMouse(const Vector3f& color) {
  return {asTarget(ellipsoidAt(Eigen::Vector3d::Zero(), {0.06, 0.032, 0.02}, color))};
}

std::vector<MovingPart> shirtOnPerson(const Walker& walker, double time) {
  std::vector<MovingPart> parts;
  for (const BodyPart& limb : bodyParts(walker, time)) {
    MovingPart part;
    part.center = limb.center;
    part.size = limb.halfSize;
    part.axes = limb.axes;
    part.color = limb.color;
    part.belongsToTarget = limb.color == walker.clothes.shirt;
    parts.push_back(part);
  }
  return parts;
}

} // namespace dewpoint::simulation
