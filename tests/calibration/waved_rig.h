// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/calibration/wand/wand_calibration.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/geometry/projector.h"
#include "tests/calibration/moved_cameras.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests::simulated {

inline constexpr double kStick = 0.6; ///< meters
inline constexpr double kRate = 15.0; ///< images per second

/// A hall with `count` (3 to 6) cameras around; places and lenses differ from seed to seed.
inline CameraRig rig(std::uint32_t seed, int count = 4) {
  const RandomStream random(17, seed, 0, RandomPurpose::Simulation);
  CameraRig cameras;
  for (int c = 0; c < count; ++c) {
    const auto draw = random.normal4(std::uint32_t(c));
    const double angle = 0.6 + 2.0 * 3.14159265 * c / count + 0.1 * draw[0];
    Camera camera;
    camera.name = "camera " + std::to_string(c + 1);
    camera.intrinsics = {640,
                         480,
                         450.0 + 10.0 * draw[1],
                         450.0 + 10.0 * draw[1],
                         320.0 + 3.0 * draw[2],
                         240.0 - 3.0 * draw[3]};
    camera.distortion[0] = -0.05;
    camera.cameraFromWorld = lookAt(
        {2.8 * std::cos(angle), 2.8 * std::sin(angle), 1.8 + 0.2 * draw[2]}, {0.0, 0.0, 0.9});
    cameras.push_back(camera);
  }
  return cameras;
}

/// Every camera moved by `place` meters and turned by `turn` radians, in directions of its own.
inline CameraRig moved(CameraRig cameras, double place, double turn, std::uint32_t seed) {
  return movedCameras(std::move(cameras), place, turn,
                      RandomStream(18, seed, 0, RandomPurpose::Simulation));
}

/// Where an end of the stick is; each seed waves differently.
inline Eigen::Vector3d waved(std::uint32_t seed, double t, std::size_t ball) {
  const RandomStream random(19, seed, 0, RandomPurpose::Simulation);
  const auto p = random.uniform3(0);
  const auto q = random.uniform3(1);
  const Eigen::Vector3d middle(0.9 * std::sin((1.1 + 0.4 * p[0]) * t + 6.0 * q[0]),
                               0.9 * std::sin((1.5 + 0.4 * p[1]) * t + 6.0 * q[1]),
                               1.0 + 0.5 * std::sin((0.9 + 0.4 * p[2]) * t + 6.0 * q[2]));
  const double a = 0.9 * t + 6.0 * p[0];
  const double b = 0.7 * t + 6.0 * p[1];
  const Eigen::Vector3d along(std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b));
  return middle + (ball == 0 ? -0.5 : 0.5) * kStick * along;
}

inline bool inImage(const Camera& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < camera.intrinsics.width &&
         pixel.y() < camera.intrinsics.height;
}

/// The stick as the cameras see it: points with Gaussian noise. `later` seconds each camera shows
/// the past.
inline WandProblem wave(const CameraRig& cameras, std::uint32_t seed, double noise, int frames,
                        const std::vector<double>& later = {}) {
  WandProblem problem;
  problem.views.resize(cameras.size());
  problem.stickLength = kStick;
  problem.startCount = 2;
  const RandomStream random(20, seed, 0, RandomPurpose::Noise);
  std::uint32_t count = 0;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Projector projector(cameras[c]);
    for (int f = 0; f < frames; ++f) {
      const double time = f / kRate;
      for (const std::size_t ball : {0U, 1U}) {
        const double shown = time - (later.empty() ? 0.0 : later[c]);
        const auto pixel = projector.project(waved(seed, shown, ball));
        const auto draw = random.normal4(count++);
        if (pixel && inImage(cameras[c], *pixel)) {
          problem.views[c].push_back(
              {time, ball, *pixel + noise * Eigen::Vector2d(draw[0], draw[1]), 0.0, noise});
        }
      }
    }
  }
  return problem;
}

} // namespace dewpoint::tests::simulated
