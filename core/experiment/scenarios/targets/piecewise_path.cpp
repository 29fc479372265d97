// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/piecewise_path.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment::scenarios {
namespace {

/// Seconds for which a hand speeds a ball up or slows it down; chosen: 1.2 to 1.6 m/s take 2 to 3
/// g.
constexpr double kSwingSeconds = 0.06;
/// Speed below which a bounce is the last, m/s: it would rise by a millimeter.
constexpr double kLeastRebound = 0.14;

} // namespace

void PiecewisePath::accelerate(const Eigen::Vector3d& acceleration, double seconds) {
  pieces_.push_back({end_, position_, velocity_, acceleration});
  position_ += seconds * velocity_ + 0.5 * seconds * seconds * acceleration;
  velocity_ += seconds * acceleration;
  end_ += seconds;
}

void PiecewisePath::rest(double seconds) {
  velocity_.setZero();
  accelerate(Eigen::Vector3d::Zero(), seconds);
}

Eigen::Vector3d PiecewisePath::operator()(double time) const {
  const auto next = std::ranges::upper_bound(pieces_, time, {}, &Piece::beginTime);
  if (next == pieces_.begin()) {
    return pieces_.empty() ? position_ : pieces_.front().position;
  }
  const Piece& piece = *(next - 1);
  const double since = std::min(time, end_) - piece.beginTime;
  return piece.position + since * piece.velocity + 0.5 * since * since * piece.acceleration;
}

void addThrow(PiecewisePath& path, const Eigen::Vector3d& to, double flight) {
  // The hand moves the ball by the mean of the speeds at release and catch, times kSwingSeconds, of
  // which gravity's part cancels; the rest of the way is flown.
  const Eigen::Vector3d way = (to - path.position()) / (1.0 + kSwingSeconds / flight);
  const Eigen::Vector3d release = way / flight - 0.5 * flight * kGravity;
  const Eigen::Vector3d caught = release + flight * kGravity;
  path.setVelocity(Eigen::Vector3d::Zero());
  path.accelerate(release / kSwingSeconds, kSwingSeconds);
  path.accelerate(kGravity, flight);
  path.accelerate(-caught / kSwingSeconds, kSwingSeconds);
}

void addCarry(PiecewisePath& path, const Eigen::Vector3d& to, double seconds) {
  const Eigen::Vector3d acceleration = 4.0 / (seconds * seconds) * (to - path.position());
  path.setVelocity(Eigen::Vector3d::Zero());
  path.accelerate(acceleration, 0.5 * seconds);
  path.accelerate(-acceleration, 0.5 * seconds);
}

void addBounces(PiecewisePath& path, const Bounce& bounce) {
  const double gravity = -kGravity.z();
  while (true) {
    const double rise = path.velocity().z();
    const double height = std::max(0.0, path.position().z() - bounce.contactHeight);
    path.accelerate(kGravity, (rise + std::sqrt(rise * rise + 2.0 * gravity * height)) / gravity);
    const Eigen::Vector3d before = path.velocity();
    const double rebound = -bounce.restitution * before.z();
    if (rebound < kLeastRebound) {
      path.setVelocity(Eigen::Vector3d::Zero());
      return;
    }
    path.setVelocity(
        {bounce.slidingRestitution * before.x(), bounce.slidingRestitution * before.y(), rebound});
  }
}

} // namespace dewpoint::experiment::scenarios
