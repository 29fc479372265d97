// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// Returns whether a position in pixels lies in an image. Pixel centers are at integer coordinates.
/// The border half of the outermost pixels, beyond their centers, does not count as inside.
inline bool isInImage(const Intrinsics& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1.0 &&
         pixel.y() <= image.height - 1.0;
}

} // namespace dewpoint::geometry
