// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/image_symmetry.h"

#include <utility>

namespace dewpoint::geometry {
namespace {

/// A quarter turn clockwise: what was at (u, v) from the center is at (-v, u) then. OpenCV's
/// tangential terms follow from asking that the distorted coordinates turn the same way.
void turnQuarter(Camera& camera) {
  Intrinsics& in = camera.intrinsics;
  const double centerX = in.height - 1 - in.centerY;
  in.centerY = in.centerX;
  in.centerX = centerX;
  std::swap(in.width, in.height);
  std::swap(in.focalX, in.focalY);
  if (camera.lens == LensModel::Pinhole) {
    const double p1 = camera.distortion[2];
    camera.distortion[2] = camera.distortion[3];
    camera.distortion[3] = -p1;
  }
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  camera.cameraFromWorld.linear() = quarter * camera.cameraFromWorld.linear();
  camera.cameraFromWorld.translation() = quarter * camera.cameraFromWorld.translation();
}

} // namespace

const std::array<ImageSymmetry, 8>& imageSymmetries() {
  static const std::array<ImageSymmetry, 8> kAll{{{0, false},
                                                  {90, false},
                                                  {180, false},
                                                  {270, false},
                                                  {0, true},
                                                  {90, true},
                                                  {180, true},
                                                  {270, true}}};
  return kAll;
}

Eigen::Vector2d transformed(const ImageSymmetry& symmetry, const Eigen::Vector2d& pixel, int width,
                            int height) {
  Eigen::Vector2d at = pixel;
  for (int rotated = 0; rotated < symmetry.rotateDegrees; rotated += 90) {
    at = Eigen::Vector2d(height - 1 - at.y(), at.x());
    std::swap(width, height);
  }
  if (symmetry.isMirrored) {
    at.x() = width - 1 - at.x();
  }
  return at;
}

Camera transformed(const ImageSymmetry& symmetry, const Camera& camera) {
  Camera result = camera;
  for (int rotated = 0; rotated < symmetry.rotateDegrees; rotated += 90) {
    turnQuarter(result);
  }
  if (symmetry.isMirrored) {
    result.intrinsics.centerX = result.intrinsics.width - 1 - result.intrinsics.centerX;
    if (result.lens == LensModel::Pinhole) {
      result.distortion[3] = -result.distortion[3];
    }
  }
  return result;
}

ImageSymmetry combined(const ImageSymmetry& first, const ImageSymmetry& second) {
  // Mirroring and then turning clockwise is turning counterclockwise and then mirroring.
  const int turn = first.isMirrored ? 360 - second.rotateDegrees : second.rotateDegrees;
  return {(first.rotateDegrees + turn) % 360, first.isMirrored != second.isMirrored};
}

} // namespace dewpoint::geometry
