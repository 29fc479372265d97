// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sphere_image.h"

#include <cmath>

namespace dewpoint::geometry {
namespace {

constexpr double kSphereStep = 1e-4; ///< of the plane z = 1, for the lens's local magnification

} // namespace

SphereProjector::SphereProjector(const Camera& camera)
    : projector_(camera), cameraCenter_(camera.center()), axis_(camera.opticalAxis()),
      right_(camera.cameraFromWorld.linear().row(0).transpose()),
      down_(camera.cameraFromWorld.linear().row(1).transpose()), distorted_(camera.hasDistortion()),
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
  const Eigen::Vector3d middle = centerWorld - (squares / depth) * axis_;
  const auto center = projector_.project(middle);
  if (!center) {
    return std::nullopt;
  }
  const double reduced = depth * depth - squares;
  const double area = std::sqrt(way.squaredNorm() - squares) / (reduced * std::sqrt(reduced));
  double magnification = focal_;
  if (distorted_) {
    // Pixels per unit of the plane z = 1 around the middle: the lens stretches and squeezes.
    const double step = kSphereStep * (depth - squares / depth);
    const auto right = projector_.project(middle + step * right_);
    const auto down = projector_.project(middle + step * down_);
    if (!right || !down) {
      return std::nullopt;
    }
    const Eigen::Vector2d a = (*right - *center) / kSphereStep;
    const Eigen::Vector2d b = (*down - *center) / kSphereStep;
    magnification = std::sqrt(std::abs(a.x() * b.y() - a.y() * b.x()));
  }
  return SphereImage{*center, magnification * radius * std::sqrt(area)};
}

} // namespace dewpoint::geometry
