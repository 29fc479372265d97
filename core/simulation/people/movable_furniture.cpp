// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/movable_furniture.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace dewpoint::simulation {
namespace {

BodyPart boxPart(const Vector3f& center, const Vector3f& halfSize, const Vector3f& color) {
  BodyPart part;
  part.center = center;
  part.halfSize = halfSize;
  part.color = color;
  part.shape = PartShape::Box;
  part.belongsToBody = false;
  return part;
}

} // namespace

FurniturePose MovableFurniture::poseAt(double time) const {
  const auto after = std::ranges::upper_bound(waypoints, time, {}, &FurniturePose::time);
  if (after == waypoints.begin()) {
    return waypoints.front();
  }
  if (after == waypoints.end()) {
    return waypoints.back();
  }
  const FurniturePose& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  return {time, before.position + part * (after->position - before.position),
          before.yaw + part * (after->yaw - before.yaw)};
}

std::vector<BodyPart> furnitureParts(const MovableFurniture& furniture, double time) {
  const FurniturePose stands = furniture.poseAt(time);
  const Eigen::Matrix3f worldFromOwn =
      Eigen::AngleAxisf(static_cast<float>(stands.yaw), Vector3f::UnitZ()).toRotationMatrix();
  const Vector3f foot{static_cast<float>(stands.position.x()),
                      static_cast<float>(stands.position.y()), 0.0F};
  std::vector<BodyPart> parts = furniture.parts;
  for (BodyPart& part : parts) {
    part.center = foot + worldFromOwn * part.center;
    part.axes = part.axes * worldFromOwn.transpose();
  }
  return parts;
}

MovableFurniture makeStool(double height) {
  // Half sizes, meters: those of a small office stool.
  constexpr float kHalfSeat = 0.17F;
  constexpr float kHalfThick = 0.02F;
  constexpr float kHalfFoot = 0.035F;
  const auto top = static_cast<float>(height);
  const float foot = 0.5F * (top - 2.0F * kHalfThick);
  const Vector3f cushion = rgb(64, 66, 74);
  const Vector3f steel = rgb(150, 152, 156);
  MovableFurniture stool;
  stool.parts = {
      boxPart({0.0F, 0.0F, top - kHalfThick}, {kHalfSeat, kHalfSeat, kHalfThick}, cushion),
      boxPart({0.0F, 0.0F, foot}, {kHalfFoot, kHalfFoot, foot}, steel)};
  stool.enclosingRadius = 0.25; // kHalfSeat to its corners, rounded up
  return stool;
}

MovableFurniture makeCabinet(const Vector3f& halfSize, const Vector3f& color) {
  MovableFurniture cabinet;
  cabinet.parts = {boxPart({0.0F, 0.0F, halfSize.z()}, halfSize, color)};
  cabinet.enclosingRadius = halfSize.head<2>().cast<double>().norm();
  return cabinet;
}

} // namespace dewpoint::simulation
