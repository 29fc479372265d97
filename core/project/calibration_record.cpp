// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/calibration_record.h"

#include "core/geometry/rotation_vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::project {
namespace {

// Differences up to which numbers are the same: what a file and a change of the world frame round.
constexpr double kSamePixels = 1e-6;
constexpr double kSameMeters = 1e-8;
constexpr double kSameRadians = 1e-8;

std::array<double, 4> numbersOf(const Intrinsics& lens) {
  return {lens.focalX, lens.focalY, lens.centerX, lens.centerY};
}

} // namespace

LensRecord recordOfLens(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error) {
  return {origin, error, numbersOf(camera.intrinsics)};
}

PoseRecord recordOfPose(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error) {
  const Eigen::Vector3d center = camera.center();
  const Eigen::Vector3d turn = vectorFromRotation(camera.cameraFromWorld.linear());
  return {origin, error, {center.x(), center.y(), center.z(), turn.x(), turn.y(), turn.z()}};
}

bool describes(const LensRecord& record, const Camera& camera) {
  return std::ranges::equal(record.describedIntrinsics, numbersOf(camera.intrinsics),
                            [](double a, double b) { return std::abs(a - b) < kSamePixels; });
}

bool describes(const PoseRecord& record, const Camera& camera) {
  const Eigen::Map<const Eigen::Vector3d> center(record.describedPose.data());
  const Eigen::Map<const Eigen::Vector3d> turn(record.describedPose.data() + 3);
  return (center - camera.center()).norm() < kSameMeters * (1.0 + center.norm()) &&
         angleBetween(rotationFromVector(turn), camera.cameraFromWorld.linear()) < kSameRadians;
}

} // namespace dewpoint::project
