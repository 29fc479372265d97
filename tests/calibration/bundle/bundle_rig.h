// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <string>
#include <vector>

/// Cameras side by side on the world's x axis that look along z, without distortion: pixels by
/// hand.
namespace dewpoint::tests::abreast {

/// Of 640 x 480 pixels, focal length 500, principal point (320, 240).
inline BundleCamera cameraAt(double x) {
  BundleCamera camera;
  camera.camera.name = "camera " + std::to_string(static_cast<int>(x) + 1);
  camera.camera.intrinsics = {640, 480, 500.0, 500.0, 320.0, 240.0};
  camera.camera.cameraFromWorld.translation() = Eigen::Vector3d(-x, 0.0, 0.0);
  return camera;
}

/// (320 + 500 (X - x) / Z, 240 + 500 Y / Z).
inline Eigen::Vector2d pixelOf(double x, const Eigen::Vector3d& point) {
  return {320.0 + 500.0 * (point.x() - x) / point.z(), 240.0 + 500.0 * point.y() / point.z()};
}

/// Where a ball is at an instant `time`, meters.
inline Eigen::Vector3d ballAt(double time) {
  return {0.2 + time, 0.1 - 0.5 * time, 4.0 + 0.2 * time};
}

/// Six instants, seconds.
inline const std::vector<double> kSix{0.0, 0.1, 0.2, 0.3, 0.4, 0.5};

/// A ball seen by cameras 0 and 1 at these instants, exactly.
inline BundleProblem ballSeenAt(const std::vector<double>& times) {
  BundleProblem problem;
  problem.cameras = {cameraAt(0.0), cameraAt(1.0)};
  problem.bodies.push_back({"ball"});
  for (std::size_t k = 0; k < times.size(); ++k) {
    BundleState state;
    state.time = times[k];
    problem.states.push_back(state);
    for (std::size_t c = 0; c < 2; ++c) {
      BundleObservation seen;
      seen.camera = c;
      seen.state = k;
      seen.pixel = pixelOf(static_cast<double>(c), ballAt(times[k]));
      problem.observations.push_back(seen);
    }
  }
  return problem;
}

} // namespace dewpoint::tests::abreast
