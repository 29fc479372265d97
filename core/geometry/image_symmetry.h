// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>

namespace dewpoint::geometry {

/// One of the eight ways to rotate and mirror an image, called symmetries here. The image is
/// rotated clockwise by 0, 90, 180 or 270 degrees, then optionally mirrored left to right. A
/// camera's source settings store the same two values.
struct ImageSymmetry {
  int rotateDegrees = 0;
  bool isMirrored = false;

  bool operator==(const ImageSymmetry&) const = default;
};

/// Returns all eight symmetries: first the identity, then the pure rotations, then the symmetries
/// with mirroring.
const std::array<ImageSymmetry, 8>& imageSymmetries();

/// Returns the position of a pixel after `symmetry` is applied to an image of `width` x `height`
/// pixels. Pixel centers are at integer coordinates.
Eigen::Vector2d transformed(const ImageSymmetry& symmetry, const Eigen::Vector2d& pixel, int width,
                            int height);

/// Returns the camera that matches the images after `symmetry` is applied to them. The intrinsics
/// and distortion coefficients change accordingly. A rotation also rotates the pose, so that every
/// world point moves together with the image content. No pose can describe a mirrored image, so
/// mirroring leaves the pose unchanged.
Camera transformed(const ImageSymmetry& symmetry, const Camera& camera);

/// Returns the symmetry that equals `first` followed by `second`.
ImageSymmetry combined(const ImageSymmetry& first, const ImageSymmetry& second);

} // namespace dewpoint::geometry
