// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace dewpoint::geometry {

/// Projects points of the world into one camera: OpenCV's models (see LensModel).
/// Prepared once per camera, then cheap per point.
class Projector {
public:
  explicit Projector(const Camera& camera);

  /// Pixel (column, row) of a world point, also outside the image; nothing behind the camera, nor
  /// beyond the angle where the distortion polynomial folds back (there it would invent an image).
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& pointWorld) const;

  /// The same for `count` points given as three columns, meters; the pixels go into two more, NaN
  /// where project() returns nothing. Equal to project() to the bit. Columns must not overlap.
  void projectBatch(std::int64_t count, const double* x, const double* y, const double* z,
                    double* column, double* row) const;

  const Intrinsics& intrinsics() const { return intrinsics_; }

private:
  Intrinsics intrinsics_;
  Projection projection_;
  LensModel lens_ = LensModel::Pinhole;
  bool distorted_ = false;
};

} // namespace dewpoint::geometry
