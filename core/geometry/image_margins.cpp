// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/image_margins.h"

#include <utility>

namespace dewpoint::geometry {

ImageMargins transformed(const ImageSymmetry& symmetry, ImageMargins margins) {
  for (int rotated = 0; rotated < symmetry.rotateDegrees; rotated += 90) {
    margins = {margins.bottom, margins.left, margins.top, margins.right};
  }
  if (symmetry.isMirrored) {
    std::swap(margins.left, margins.right);
  }
  return margins;
}

Camera recropped(Camera camera, const ImageMargins& before, const ImageMargins& after) {
  Intrinsics& in = camera.intrinsics;
  in.width += before.width() - after.width();
  in.height += before.height() - after.height();
  in.centerX += before.left - after.left;
  in.centerY += before.top - after.top;
  return camera;
}

} // namespace dewpoint::geometry
