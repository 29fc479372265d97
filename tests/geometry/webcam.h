// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <array>

namespace dewpoint::tests {

/// A webcam at QVGA, roughly as in method B's setup, turned and moved so that every axis counts.
inline Camera webcam(const std::array<double, 8>& distortion = {}) {
  Camera camera;
  camera.name = "left";
  camera.intrinsics = {320, 240, 405.0, 398.0, 158.5, 122.25};
  camera.distortion = distortion;
  camera.cameraFromWorld = lookAt({0.5, 0.0, 0.195}, {0.3, 0.6, 0.1}, {0, 0, 1}, 0.3);
  return camera;
}

} // namespace dewpoint::tests
