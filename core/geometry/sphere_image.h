// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::geometry {

/// Outline of a sphere in an image, in pixels. The true outline is an ellipse; it is represented by
/// the circle with the same center and area.
struct SphereImage {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// Projects spheres into one camera. The center of the outline is not the projection of the
/// sphere's center. Perspective moves the center of the outline away from the optical axis, by half
/// a pixel or more for a near ball.
class SphereProjector {
public:
  explicit SphereProjector(const Camera& camera);

  /// Returns the outline of a sphere whose center is `centerWorld` (world frame) and whose radius
  /// is `radius`, both in meters. The outline may lie outside the image. Returns nothing if the
  /// sphere reaches behind the camera or beyond the valid range of the lens model.
  std::optional<SphereImage> project(const Eigen::Vector3d& centerWorld, double radius) const;

  /// Returns the distance (meters) of a world point from the camera along the optical axis. The
  /// result is negative for a point behind the camera.
  double depth(const Eigen::Vector3d& pointWorld) const {
    return (pointWorld - cameraCenter_).dot(axis_);
  }

  /// Returns the optical center in the world frame, meters.
  const Eigen::Vector3d& cameraCenter() const { return cameraCenter_; }
  const Projector& projector() const { return projector_; }

private:
  Projector projector_;
  Eigen::Vector3d cameraCenter_;
  Eigen::Vector3d axis_;
  Eigen::Vector3d right_;
  Eigen::Vector3d down_;
  bool distorted_ = false;
  double focal_ = 0.0; ///< geometric mean of both focal lengths, pixels
};

} // namespace dewpoint::geometry
