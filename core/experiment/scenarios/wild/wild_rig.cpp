// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/wild/wild_rig.h"

#include "core/simulation/body/usual_ball.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment::scenarios {
namespace {

/// Pixels across: about the smallest disc whose color a mosaic still shows.
constexpr double kSmallestTarget = 4.0;
/// Of the smaller side of the image: a ball held towards the camera.
constexpr double kLargestTarget = 0.5;
/// The least radius, of the usual one: a marble instead of a tennis ball.
constexpr double kLeastRadius = 0.4;
/// The least focal length, of the usual one: 91 degrees across instead of 49.
constexpr double kLeastFocal = 0.45;
/// The least resolution, of the usual one: 160 x 120, the smallest that webcams have.
constexpr double kLeastResolution = 0.5;
/// Cameras are within this of the middle of the room along x and y, meters: 0.15 m before the walls
/// of the room with the desk, 0.1 m before those of the hall.
constexpr double kWithin = simulation::kDeskRoomHalfSize - 0.15;
constexpr double kWithinHall = simulation::kHallHalfSize - 0.1;
/// Of cameras above the ground, meters: that of a webcam that stands on the desk.
constexpr double kLeastHeight = 0.06;

/// No two cameras of a room have quite the same lens: share of the focal length, either way;
/// chosen.
constexpr double kLensSpread = 0.1;
/// Of the size that paths could have with a longer lens: what the lenses' spread and the cameras'
/// other aim need.
constexpr double kSpare = 0.8;

/// What the cameras of a rig look at, and what they look for.
struct RigVolume {
  Eigen::Vector3d middle;
  Eigen::Vector2d room;                           ///< middle of the walls
  double radius = simulation::kDefaultBallRadius; ///< of the targets, before they are shrunk
  double size = 1.0;                              ///< of all distances, relative to a desk
};

RigVolume volumeOf(simulation::Furnishing furnishing) {
  if (furnishing == simulation::Furnishing::Hall) {
    return {{0.0, 0.0, 0.9}, {0.0, 0.0}, simulation::kHallBallRadius, 4.0};
  }
  return {simulation::kDeskCenter, Eigen::Vector2d::Constant(simulation::kDeskRoomCenter),
          simulation::kDefaultBallRadius, 1.0};
}

/// Pixels across of a target in the middle.
double targetPixels(const Camera& camera, const RigVolume& volume) {
  return 2.0 * volume.radius * camera.intrinsics.focalX / (camera.center() - volume.middle).norm();
}

Camera movedCamera(Camera camera, const RigVolume& volume, RandomDraws& draws) {
  // Chosen: cameras put up by hand, about where the scenario wants them.
  constexpr double kAround = 0.3;  // radians, either way
  constexpr double kRoll = 0.15;   // radians, either way
  constexpr double kAway = 0.15;   // of the distance, either way
  constexpr double kAim = 0.02;    // meters at a desk
  constexpr double kHeight = 0.05; // meters at a desk
  const Eigen::AngleAxisd around(draws.drawUniform(-kAround, kAround), Eigen::Vector3d::UnitZ());
  const double scale = draws.drawUniform(1.0 - kAway, 1.0 + kAway);
  Eigen::Vector3d center = volume.middle + scale * (around * (camera.center() - volume.middle));
  center.z() += volume.size * draws.drawUniform(-kHeight, kHeight);
  const double reach = volume.size > 1.0 ? kWithinHall : kWithin; // not in a wall
  for (int axis = 0; axis < 2; ++axis) {
    center[axis] = std::clamp(center[axis], volume.room[axis] - reach, volume.room[axis] + reach);
  }
  center.z() = std::max(center.z(), kLeastHeight);
  const Eigen::Vector3d aim = Eigen::Vector3d::Constant(volume.size * kAim);
  const Eigen::Vector3d target = volume.middle + draws.drawPointInBox(-aim, aim);
  camera.cameraFromWorld =
      lookAt(center, target, Eigen::Vector3d::UnitZ(), draws.drawUniform(-kRoll, kRoll));
  return camera;
}

/// The same lens on a sensor with `scale` as many pixels each way, then a longer lens.
void setSize(Intrinsics& k, double resolution, double focal) {
  const auto even = [](double pixels) { return 2 * static_cast<int>(std::lround(0.5 * pixels)); };
  const int width = even(resolution * k.width);
  const double scale = static_cast<double>(width) / k.width;
  k.height = even(resolution * k.height);
  k.width = width;
  k.focalX *= scale * focal;
  k.focalY *= scale * focal;
  k.centerX = (k.width - 1) / 2.0;
  k.centerY = (k.height - 1) / 2.0;
}

} // namespace

WildRig randomRig(const CameraRig& rig, simulation::Furnishing furnishing, int attempt,
                  RandomDraws& draws) {
  const RigVolume volume = volumeOf(furnishing);
  WildRig result;
  for (const Camera& camera : rig) {
    result.rig.push_back(movedCamera(camera, volume, draws));
  }
  const Intrinsics& first = rig.front().intrinsics;
  const double largest = kLargestTarget * std::min(first.width, first.height);
  const double wanted = std::exp(draws.drawUniform(std::log(kSmallestTarget), std::log(largest)));
  double factor = wanted / targetPixels(result.rig.front(), volume);
  double resolution = 1.0;
  if (factor < 1.0) {
    result.radiusScale = std::max(kLeastRadius, factor);
    const double rest = factor / result.radiusScale;
    factor = std::max(kLeastFocal, rest);
    resolution = std::clamp(rest / factor, kLeastResolution, 1.0);
  } else {
    factor = std::pow(factor, 1.0 - static_cast<double>(attempt) / (kMaxRigAttempts - 1));
    result.pathScale = kSpare / factor;
  }
  for (Camera& camera : result.rig) {
    setSize(camera.intrinsics, resolution,
            factor * draws.drawUniform(1.0 - kLensSpread, 1.0 + kLensSpread));
  }
  return result;
}

} // namespace dewpoint::experiment::scenarios
