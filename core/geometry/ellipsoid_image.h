// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::geometry {

/// A solid ellipsoid in the world.
struct Ellipsoid {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters
  /// Extent (m²): symmetric, its eigenvalues are the squares of the semi-axes, its eigenvectors
  /// their directions. The second moments of the solid are a fifth of it.
  Eigen::Matrix3d extent = Eigen::Matrix3d::Zero();

  /// Of a ball of the same volume, meters.
  double radius() const;
};

/// The outline of an ellipsoid in an image.
struct EllipseImage {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< pixels
  /// px²: its eigenvalues are the squares of the semi-axes. The second moments of the area inside
  /// are a quarter of it.
  Eigen::Matrix2d extent = Eigen::Matrix2d::Zero();

  /// Pixels.
  double area() const;
  /// Squared distance from the center in semi-axes: at most 1 inside.
  double squaredDistance(const Eigen::Vector2d& pixel) const;
};

/// Where an ellipsoid appears in one camera: the cone of its tangents, exact for a pinhole; a lens
/// that distorts is linear over the outline.
class EllipsoidProjector {
public:
  explicit EllipsoidProjector(const Camera& camera);

  /// Also outside the image; nothing when the ellipsoid reaches behind the camera or past where the
  /// lens model holds.
  std::optional<EllipseImage> project(const Ellipsoid& ellipsoid) const;
  const Projector& projector() const { return projector_; }
  /// Optical center, meters, world.
  const Eigen::Vector3d& cameraCenter() const { return cameraCenter_; }
  /// Pixels per radian along the optical axis.
  double focal() const { return focal_; }

private:
  Projector projector_;
  Eigen::Isometry3d cameraFromWorld_;
  Eigen::Isometry3d worldFromCamera_;
  Eigen::Vector3d cameraCenter_;
  double focal_ = 0.0;
};

} // namespace dewpoint::geometry
