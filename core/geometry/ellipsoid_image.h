// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::geometry {

/// Solid ellipsoid in the world frame.
struct Ellipsoid {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters
  /// Extent (m²): a symmetric matrix whose eigenvalues are the squares of the semi-axes and whose
  /// eigenvectors are the directions of the axes. The covariance of the points inside is one fifth
  /// of this matrix.
  Eigen::Matrix3d extent = Eigen::Matrix3d::Zero();

  /// Returns the radius of a ball with the same volume, meters.
  double radius() const;
};

/// Returns the extent (m²) of a ball with this radius (meters).
Eigen::Matrix3d ballExtent(double radius);

/// Outline of an ellipsoid in an image.
struct EllipseImage {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< pixels
  /// Extent (px²): a symmetric matrix whose eigenvalues are the squares of the semi-axes. The
  /// covariance of the pixels inside is one quarter of this matrix.
  Eigen::Matrix2d extent = Eigen::Matrix2d::Zero();

  /// Returns the enclosed area, px².
  double area() const;
  /// Returns the squared distance of a pixel from the center, where the distance along each axis is
  /// measured in units of its semi-axis. The result is at most 1 inside the ellipse.
  double squaredDistance(const Eigen::Vector2d& pixel) const;
};

/// Projects ellipsoids into the image of one camera. Method: the tangent cone from the optical
/// center, which is exact for a pinhole. Lens distortion is linearized over the outline.
class EllipsoidProjector {
public:
  explicit EllipsoidProjector(const Camera& camera);

  /// Returns the outline of the ellipsoid, which may lie outside the image. Returns nothing if the
  /// ellipsoid reaches behind the camera or beyond the valid range of the lens model.
  std::optional<EllipseImage> project(const Ellipsoid& ellipsoid) const;
  const Projector& projector() const { return projector_; }
  /// Returns the optical center in the world frame, meters.
  const Eigen::Vector3d& cameraCenter() const { return cameraCenter_; }
  /// Returns the focal length in pixels: pixels per radian near the optical axis.
  double focalLength() const { return focal_; }

private:
  Projector projector_;
  Eigen::Isometry3d cameraFromWorld_;
  Eigen::Isometry3d worldFromCamera_;
  Eigen::Vector3d cameraCenter_;
  double focal_ = 0.0;
};

} // namespace dewpoint::geometry
