// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/hidden_share.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::experiment::scenarios {
namespace {

/// The turn from one point of a sunflower to the next, radians (Vogel, Math. Biosciences 1979).
const double kGoldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));

bool isMet(const std::vector<simulation::MovingPart>& parts, const Eigen::Vector3d& eye,
           const Eigen::Vector3d& direction, double limit) {
  simulation::PartHit hit;
  hit.distance = static_cast<float>(limit);
  for (const simulation::MovingPart& part : parts) {
    intersectPart(part, eye.cast<float>(), direction.cast<float>(), hit);
  }
  return hit.part != nullptr;
}

/// Share of the disc's rays that meet a part: nearer than the ball, or anywhere.
double metShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                const std::vector<simulation::MovingPart>& parts, bool anywhere) {
  const Eigen::Vector3d way = center - eye;
  const double distance = way.norm();
  if (distance <= radius) {
    return 1.0;
  }
  const Eigen::Vector3d axis = way / distance;
  const Eigen::Vector3d right = axis.unitOrthogonal();
  const Eigen::Vector3d down = axis.cross(right);
  const double outline = std::asin(radius / distance); // the disc's radius as an angle
  int met = 0;
  for (int i = 0; i < kDiskPoints; ++i) {
    const double angle = outline * std::sqrt((i + 0.5) / kDiskPoints);
    const double turn = kGoldenAngle * i;
    const Eigen::Vector3d aside = std::cos(turn) * right + std::sin(turn) * down;
    const Eigen::Vector3d direction = std::cos(angle) * axis + std::sin(angle) * aside;
    // Where the ray enters the ball.
    const double miss = distance * std::sin(angle);
    const double entry =
        distance * std::cos(angle) - std::sqrt(std::max(0.0, radius * radius - miss * miss));
    const double limit = anywhere ? std::numeric_limits<double>::infinity() : entry;
    met += isMet(parts, eye, direction, limit) ? 1 : 0;
  }
  return static_cast<double>(met) / kDiskPoints;
}

} // namespace

double hiddenShare(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                   const std::vector<simulation::MovingPart>& parts) {
  return metShare(eye, center, radius, parts, false);
}

double overlappedFraction(const Eigen::Vector3d& eye, const Eigen::Vector3d& center, double radius,
                          const std::vector<simulation::MovingPart>& parts) {
  return metShare(eye, center, radius, parts, true);
}

simulation::MovingPart boxPart(const simulation::StageBody& box, double time) {
  simulation::MovingPart part;
  part.shape = simulation::MovingShape::Box;
  part.center = box.path(time).cast<float>();
  part.size = box.halfSize.cast<float>();
  part.axes = box.axes.cast<float>();
  return part;
}

} // namespace dewpoint::experiment::scenarios
