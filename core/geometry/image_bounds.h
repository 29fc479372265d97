// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// Returns whether a pixel lies within an image, up to the centers of the outermost pixels.
inline bool isInImage(const Intrinsics& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1.0 &&
         pixel.y() <= image.height - 1.0;
}

} // namespace dewpoint::geometry
