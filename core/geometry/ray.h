// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::geometry {

/// Half-line in the world frame: `origin` is in meters, and `direction` has length 1.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Inverse of Projector: converts a pixel of one camera to a ray in the world. Create one object
/// per camera and reuse it: construction prepares data that makes converting a pixel fast.
class Unprojector {
public:
  explicit Unprojector(const Camera& camera);

  /// Returns the direction in which the camera sees the pixel (column, row), as a unit vector in
  /// the world frame. The pixel may lie outside the image. Lens distortion is inverted by Newton's
  /// method on Projector's model, to 1e-9 px. Returns nothing if the pixel is not finite, or if it
  /// is so far out that the lens model maps no direction to it.
  std::optional<Eigen::Vector3d> worldDirection(const Eigen::Vector2d& pixel) const;

  /// Returns the ray from the camera's center in the direction worldDirection(), or nothing if
  /// there is no such direction.
  std::optional<Ray> ray(const Eigen::Vector2d& pixel) const;

  /// Returns the optical center in the world frame, meters.
  const Eigen::Vector3d& center() const { return center_; }

private:
  std::optional<Eigen::Vector2d> normalized(const Eigen::Vector2d& pixel) const;

  Intrinsics intrinsics_;
  Eigen::Matrix3d worldFromCamera_;
  Eigen::Vector3d center_;
  bool distorted_ = false;
  bool fisheye_ = false;
  std::array<double, 8> distortion_;
  Projector lens_; ///< the same lens, with the camera at the world origin
};

/// Returns the point (world, meters) with the smallest sum of squared distances to the lines of the
/// rays. Method: the normal equations sum (I - d d') X = sum (I - d d') o, where X is the point, o
/// the origin and d the direction of each ray. For two rays, Hartley & Zisserman call this the
/// midpoint method. Returns nothing for fewer than two rays, for rays within about 0.1 degrees of
/// parallel, or if the point lies behind the origin of a ray.
std::optional<Eigen::Vector3d> nearestPoint(const std::vector<Ray>& rays);

/// Returns the distance of a point to the ray in meters. If the point lies behind the origin, this
/// is the distance to the origin.
double distanceToRay(const Ray& ray, const Eigen::Vector3d& point);

} // namespace dewpoint::geometry
