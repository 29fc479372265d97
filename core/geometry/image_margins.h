// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/image_symmetry.h"

namespace dewpoint::geometry {

/// Margins that are cut off at the edges of an image, in pixels. An image is first rotated and
/// mirrored, then cropped.
struct ImageMargins {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  int width() const { return left + right; }  ///< by how many pixels the image becomes narrower
  int height() const { return top + bottom; } ///< by how many pixels the image becomes lower
  bool isZeroOnAllSides() const { return *this == ImageMargins(); }
  bool operator==(const ImageMargins&) const = default;
};

/// Returns the margins that cut off the same pixels after `symmetry` was applied to the image.
ImageMargins transformed(const ImageSymmetry& symmetry, ImageMargins margins);

/// Returns the camera after a change of its cropping margins from `before` to `after`. Only the
/// image size and the principal point change.
Camera recropped(Camera camera, const ImageMargins& before, const ImageMargins& after);

} // namespace dewpoint::geometry
