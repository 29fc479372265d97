// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>

namespace dewpoint::geometry {

/// One of the eight ways a picture can lie: rotated clockwise by 0, 90, 180 or 270 degrees, and
/// then perhaps mirrored left to right. The same two numbers say it of a camera's source.
struct ImageSymmetry {
  int rotateDegrees = 0;
  bool mirrored = false;

  bool operator==(const ImageSymmetry&) const = default;
};

/// Identity first, then the rotations, then the mirrored ones.
const std::array<ImageSymmetry, 8>& imageSymmetries();

/// Where a pixel of an image of this size (pixels) comes to lie; centers of pixels at integers.
Eigen::Vector2d transformed(const ImageSymmetry& symmetry, const Eigen::Vector2d& pixel, int width,
                            int height);

/// The intrinsics and lens coefficients of the same camera when its pictures are transformed so. A
/// rotation also turns the pose, so that every world point moves with its pixel; what a mirrored
/// picture shows has no pose, so a mirroring leaves it as it is.
Camera transformed(const ImageSymmetry& symmetry, const Camera& camera);

/// What one symmetry does after another.
ImageSymmetry combined(const ImageSymmetry& first, const ImageSymmetry& second);

} // namespace dewpoint::geometry
