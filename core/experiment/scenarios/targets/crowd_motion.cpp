// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/crowd_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// Instants per second; chosen. At 0.3 m/s a ball moves by 1.25 mm from one to the next.
constexpr double kRate = 240.0;
/// Rounds in which balls that overlap are pushed apart: three in a row need one per pair.
constexpr int kPushes = 20;

struct Balls {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> velocities;
};

void rebound(Balls& balls, std::size_t one, std::size_t other, double radius, bool& touched) {
  const Eigen::Vector3d way = balls.positions[other] - balls.positions[one];
  const double distance = way.norm();
  if (distance >= 2.0 * radius || distance == 0.0) {
    return;
  }
  touched = true;
  const Eigen::Vector3d normal = way / distance;
  const Eigen::Vector3d push = (radius - 0.5 * distance) * normal;
  balls.positions[one] -= push;
  balls.positions[other] += push;
  // Equal masses: the speeds along the line of the centers change hands.
  const double closing = (balls.velocities[one] - balls.velocities[other]).dot(normal);
  if (closing > 0.0) {
    balls.velocities[one] -= closing * normal;
    balls.velocities[other] += closing * normal;
  }
}

void keepInside(const Eigen::AlignedBox3d& region, Eigen::Vector3d& position,
                Eigen::Vector3d& velocity) {
  for (int axis = 0; axis < 3; ++axis) {
    if (position[axis] < region.min()[axis]) {
      position[axis] = region.min()[axis];
      velocity[axis] = std::abs(velocity[axis]);
    } else if (position[axis] > region.max()[axis]) {
      position[axis] = region.max()[axis];
      velocity[axis] = -std::abs(velocity[axis]);
    }
  }
}

void step(Balls& balls, const Eigen::AlignedBox3d& region, double radius) {
  const std::size_t count = balls.positions.size();
  for (std::size_t i = 0; i < count; ++i) {
    balls.positions[i] += balls.velocities[i] / kRate;
  }
  bool touched = true;
  for (int round = 0; round < kPushes && touched; ++round) {
    touched = false;
    for (std::size_t i = 0; i < count; ++i) {
      keepInside(region, balls.positions[i], balls.velocities[i]);
    }
    for (std::size_t one = 0; one < count; ++one) {
      for (std::size_t other = one + 1; other < count; ++other) {
        rebound(balls, one, other, radius, touched);
      }
    }
  }
}

} // namespace

CrowdMotion::CrowdMotion(const CrowdStart& start, const Eigen::AlignedBox3d& region, double radius,
                         double seconds)
    : count_(start.positions.size()) {
  Balls balls{start.positions, start.velocities};
  const auto steps = static_cast<std::size_t>(std::ceil(std::max(0.0, seconds) * kRate));
  positions_.reserve((steps + 1) * count_);
  positions_.insert(positions_.end(), balls.positions.begin(), balls.positions.end());
  for (std::size_t k = 0; k < steps; ++k) {
    step(balls, region, radius);
    positions_.insert(positions_.end(), balls.positions.begin(), balls.positions.end());
  }
}

Eigen::Vector3d CrowdMotion::position(std::size_t ball, double time) const {
  const std::size_t last = positions_.size() / count_ - 1;
  const double instant = std::clamp(time * kRate, 0.0, static_cast<double>(last));
  const auto before = std::min(static_cast<std::size_t>(instant), last > 0 ? last - 1 : 0);
  const double share = instant - static_cast<double>(before);
  const Eigen::Vector3d& from = positions_.at(before * count_ + ball);
  const Eigen::Vector3d& to = positions_.at(std::min(before + 1, last) * count_ + ball);
  return from + share * (to - from);
}

simulation::Path pathOf(std::shared_ptr<const CrowdMotion> motion, std::size_t ball) {
  return [motion = std::move(motion), ball](double time) { return motion->position(ball, time); };
}

} // namespace dewpoint::experiment::scenarios
