// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace dewpoint::tests {

/// Every camera moved by `place` meters and turned by `turn` radians, in directions of its own.
inline CameraRig movedCameras(CameraRig cameras, double place, double turn,
                              const RandomStream& random) {
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const auto a = random.normal4(std::uint32_t(c));
    const auto b = random.normal4(std::uint32_t(c), 1);
    const Eigen::Vector3d center =
        cameras[c].center() + place * Eigen::Vector3d(a[0], a[1], a[2]).normalized();
    auto& pose = cameras[c].cameraFromWorld;
    pose.linear() =
        rotationExponential(turn * Eigen::Vector3d(b[0], b[1], b[2]).normalized()) * pose.linear();
    pose.translation() = -pose.linear() * center;
  }
  return cameras;
}

/// The same; each seed moves them otherwise.
inline CameraRig movedCameras(CameraRig cameras, double place, double turn, std::uint32_t seed) {
  return movedCameras(std::move(cameras), place, turn,
                      RandomStream(5, seed, 0, RandomPurpose::Noise));
}

} // namespace dewpoint::tests
