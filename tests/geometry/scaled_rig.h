// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

namespace dewpoint::tests {

/// The rig with all distances between its cameras and the origin times a factor.
inline geometry::CameraRig scaled(geometry::CameraRig rig, double factor) {
  for (geometry::Camera& camera : rig) {
    camera.cameraFromWorld.translation() *= factor;
  }
  return rig;
}

} // namespace dewpoint::tests
