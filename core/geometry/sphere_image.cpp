// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sphere_image.h"

#include <cmath>

namespace dewpoint {

SphereProjector::SphereProjector(const Camera& camera)
    : projector_(camera), cameraCenter_(camera.center()), axis_(camera.opticalAxis()),
      focal_(std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY)) {}

std::optional<SphereImage> SphereProjector::project(const Eigen::Vector3d& centerWorld,
                                                    double radius) const {
  // For a sphere at (X, Y, Z) in camera axes the cone of tangents cuts the plane z = 1 in an
  // ellipse about (X, Y) Z / (Z² - R²) of area pi R² sqrt(d² - R²) / (Z² - R²)^(3/2), d² = X² + Y²
  // + Z². Its middle is therefore the projection of (X, Y, Z - R²/Z).
  const Eigen::Vector3d way = centerWorld - cameraCenter_;
  const double depth = way.dot(axis_);
  const double squares = radius * radius;
  if (!(depth > radius)) {
    return std::nullopt; // also refuses NaN
  }
  const auto center = projector_.project(centerWorld - (squares / depth) * axis_);
  if (!center) {
    return std::nullopt;
  }
  const double reduced = depth * depth - squares;
  const double area = std::sqrt(way.squaredNorm() - squares) / (reduced * std::sqrt(reduced));
  return SphereImage{*center, focal_ * radius * std::sqrt(area)};
}

} // namespace dewpoint
