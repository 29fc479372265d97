// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::geometry {

/// A half-line in the world: `origin` in meters, `direction` of length 1.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// The inverse of Projector: from a pixel of one camera to its ray in the world. Prepared once per
/// camera, then cheap per pixel.
class Unprojector {
public:
  explicit Unprojector(const Camera& camera);

  /// Unit direction, in the world, of the pixel (column, row), also outside the image. Lens
  /// distortion is undone by Newton's method on Projector's own model, to 1e-9 px; nothing where
  /// the model has no such direction (beyond its fold-back) or the pixel is not finite.
  std::optional<Eigen::Vector3d> rayWorld(const Eigen::Vector2d& pixel) const;

  /// The same with the camera's center as its origin.
  std::optional<Ray> ray(const Eigen::Vector2d& pixel) const;

  const Eigen::Vector3d& center() const { return center_; }

private:
  std::optional<Eigen::Vector2d> normalized(const Eigen::Vector2d& pixel) const;

  Intrinsics intrinsics_;
  Eigen::Matrix3d worldFromCamera_;
  Eigen::Vector3d center_;
  bool distorted_ = false;
  bool fisheye_ = false;
  std::array<double, 8> distortion_;
  Projector lens_; ///< the same lens with the camera at the world's origin
};

/// The point with the least sum of squared distances to the rays' lines (the normal equations
/// sum (I - d d') X = sum (I - d d') o; Hartley & Zisserman call two of them the midpoint method).
/// Nothing for fewer than two rays, for rays closer than about 0.1 degrees to parallel, or when the
/// point lies behind the origin of one.
std::optional<Eigen::Vector3d> nearestPoint(const std::vector<Ray>& rays);

/// Distance of a point to the ray: to its origin where the point lies behind it. Meters.
double distanceToRay(const Ray& ray, const Eigen::Vector3d& point);

} // namespace dewpoint::geometry
