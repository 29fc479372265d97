// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace dewpoint::geometry {

/// Projects world points into one camera with OpenCV's models (see LensModel). Create one object
/// per camera and reuse it: construction prepares data that makes projecting a point fast.
class Projector {
public:
  explicit Projector(const Camera& camera);

  /// Returns the pixel (column, row) of a world point in meters. The pixel may lie outside the
  /// image. Returns nothing for a point behind the camera. Also returns nothing for a point beyond
  /// the angle at which the distortion polynomial folds back, because its computed pixel would be
  /// wrong.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& pointWorld) const;

  /// Projects `count` points given as three columns, meters. The pixels are written to two more
  /// columns, with NaN where project() returns nothing. The results are bit-identical to the
  /// results of project(). Columns must not overlap.
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
