// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::geometry {

/// The outline of a sphere in an image: an ellipse, described by the circle of the same center and
/// area. Pixels.
struct SphereImage {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// Where a sphere appears in one camera. The center of its outline is not the projection of its
/// center: perspective pushes it away from the optical axis, by half a pixel and more for a near
/// ball.
class SphereProjector {
public:
  explicit SphereProjector(const Camera& camera);

  /// Outline of the sphere of `radius` meters around `centerWorld` (meters, world), also outside
  /// the image; nothing when it reaches behind the camera or past where the lens model holds.
  std::optional<SphereImage> project(const Eigen::Vector3d& centerWorld, double radius) const;

  /// Meters in front of the camera, along its optical axis.
  double depth(const Eigen::Vector3d& pointWorld) const {
    return (pointWorld - cameraCenter_).dot(axis_);
  }

  /// Optical center, meters, world.
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
