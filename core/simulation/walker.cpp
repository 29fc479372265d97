// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/walker.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::simulation {
namespace {

constexpr double kRounding = 0.4;     ///< seconds over which corners of the way are rounded off
constexpr double kStrideLength = 1.4; ///< meters of two steps
constexpr double kUsualSpeed = 1.2;   ///< m/s at which limbs swing fully

Eigen::Vector2d onWay(const std::vector<Waypoint>& way, double time) {
  const auto after = std::ranges::upper_bound(way, time, {}, &Waypoint::time);
  if (after == way.begin()) {
    return way.front().position;
  }
  if (after == way.end()) {
    return way.back().position;
  }
  const Waypoint& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  return before.position + part * (after->position - before.position);
}

/// Distance gone since the first waypoint, meters.
double gone(const std::vector<Waypoint>& way, double time) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size() && way[k - 1].time < time; ++k) {
    const double end = std::min(time, way[k].time);
    const double length = (way[k].position - way[k - 1].position).norm();
    sum += length * (end - way[k - 1].time) / (way[k].time - way[k - 1].time);
  }
  return sum;
}

/// How a body stands: its own axes (forward, left, up) and size.
struct Stance {
  Vector3f foot;
  Eigen::Matrix3f axes; ///< rows: forward, left, up
  float scale = 1.0F;

  Vector3f at(float forward, float left, float up) const {
    return foot + axes.transpose() * (scale * Vector3f{forward, left, up});
  }
};

/// A limb that hangs from `joint`, swung forward by `angle`; returns where it ends.
Vector3f addLimb(const Stance& stance, const Vector3f& joint, float length, float thickness,
                 float angle, const Vector3f& color, std::vector<BodyPart>& parts) {
  const Vector3f forward = stance.axes.row(0);
  const Vector3f up = stance.axes.row(2);
  const Vector3f along = std::sin(angle) * forward - std::cos(angle) * up;
  const Vector3f end = joint + stance.scale * length * along;
  BodyPart part;
  part.center = 0.5F * (joint + end);
  part.halfSize = stance.scale * Vector3f{thickness, thickness, 0.55F * length};
  part.axes.row(2) = along;
  part.axes.row(1) = stance.axes.row(1);
  part.axes.row(0) = Vector3f(part.axes.row(1)).cross(along);
  part.color = color;
  parts.push_back(part);
  return end;
}

} // namespace

Eigen::Vector2d Walker::position(double time) const {
  constexpr int kSamples = 9;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k < kSamples; ++k) {
    sum += onWay(way, time + kRounding * ((k + 0.5) / kSamples - 0.5));
  }
  return sum / kSamples;
}

std::vector<BodyPart> bodyParts(const Walker& walker, double time) {
  constexpr double kHeadingSpan = 0.6; // seconds: turning takes a while
  const Eigen::Vector2d position = walker.position(time);
  Eigen::Vector2d going =
      walker.position(time + 0.5 * kHeadingSpan) - walker.position(time - 0.5 * kHeadingSpan);
  const double speed = going.norm() / kHeadingSpan;
  if (speed < 0.05) { // stands: looks where it came from, or will go
    going = walker.way.back().position - walker.way.front().position;
  }
  const Eigen::Vector2d ahead =
      going.norm() > 1e-6 ? Eigen::Vector2d(going.normalized()) : Eigen::Vector2d(1.0, 0.0);
  Stance stance;
  stance.foot = {static_cast<float>(position.x()), static_cast<float>(position.y()), 0.0F};
  const auto c = static_cast<float>(ahead.x());
  const auto s = static_cast<float>(ahead.y());
  stance.axes << c, s, 0.0F, -s, c, 0.0F, 0.0F, 0.0F, 1.0F;
  stance.scale = static_cast<float>(walker.height / 1.75);
  const double phase = 2.0 * std::numbers::pi * gone(walker.way, time) / kStrideLength;
  const auto swing = static_cast<float>(0.5 * std::min(1.0, speed / kUsualSpeed) * std::sin(phase));

  const Clothes& wears = walker.clothes;
  std::vector<BodyPart> parts;
  const auto trunk = [&](float up, const Vector3f& half, const Vector3f& color) {
    parts.push_back({stance.at(0.0F, 0.0F, up), stance.scale * half, stance.axes, color});
  };
  trunk(1.61F, {0.095F, 0.08F, 0.125F}, wears.skin);
  parts.push_back({stance.at(-0.02F, 0.0F, 1.655F), stance.scale * Vector3f{0.095F, 0.085F, 0.1F},
                   stance.axes, wears.hair});
  trunk(1.21F, {0.125F, 0.195F, 0.29F}, wears.shirt);
  trunk(0.93F, {0.12F, 0.165F, 0.15F}, wears.trousers);
  for (const float side : {-1.0F, 1.0F}) {
    const float leg = side * swing;
    const Vector3f knee = addLimb(stance, stance.at(0.0F, 0.09F * side, 0.90F), 0.44F, 0.08F, leg,
                                  wears.trousers, parts);
    addLimb(stance, knee, 0.44F, 0.055F, leg - 0.5F * std::abs(swing), wears.trousers, parts);
    const Vector3f elbow = addLimb(stance, stance.at(0.0F, 0.225F * side, 1.43F), 0.30F, 0.05F,
                                   -0.8F * leg, wears.shirt, parts);
    addLimb(stance, elbow, 0.28F, 0.04F, -0.8F * leg + 0.35F, wears.shirt, parts);
  }
  return parts;
}

} // namespace dewpoint::simulation
