// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/ellipsoid_image.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::geometry {
namespace {

constexpr double kStep = 1e-4; ///< of the plane z = 1, for the lens's local magnification

} // namespace

double Ellipsoid::radius() const {
  // The determinant is the product of the squares of the three semi-axes.
  return std::pow(std::max(0.0, extent.determinant()), 1.0 / 6.0);
}

Eigen::Matrix3d ballExtent(double radius) {
  return radius * radius * Eigen::Matrix3d::Identity();
}

double EllipseImage::area() const {
  return std::numbers::pi * std::sqrt(std::max(0.0, extent.determinant()));
}

double EllipseImage::squaredDistance(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d off = pixel - center;
  return off.dot(extent.inverse() * off);
}

EllipsoidProjector::EllipsoidProjector(const Camera& camera)
    : projector_(camera), cameraFromWorld_(camera.cameraFromWorld),
      worldFromCamera_(camera.cameraFromWorld.inverse()), cameraCenter_(camera.center()),
      focal_(std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY)) {}

std::optional<EllipseImage> EllipsoidProjector::project(const Ellipsoid& ellipsoid) const {
  // The dual conic of the outline is A - c c' for an ellipsoid of extent A about c in camera axes
  // (Hartley & Zisserman, Multiple View Geometry, 2nd ed., result 8.9).
  const Eigen::Vector3d c = cameraFromWorld_ * ellipsoid.center;
  const Eigen::Matrix3d rotation = cameraFromWorld_.linear();
  const Eigen::Matrix3d a = rotation * ellipsoid.extent * rotation.transpose();
  const double reduced = c.z() * c.z() - a(2, 2);
  if (!(c.z() > 0.0 && reduced > 0.0)) {
    return std::nullopt; // also refuses NaN
  }
  const Eigen::Vector2d middle = (c.z() * c.head<2>() - a.block<2, 1>(0, 2)) / reduced;
  const Eigen::Matrix2d flat =
      middle * middle.transpose() +
      (a.topLeftCorner<2, 2>() - c.head<2>() * c.head<2>().transpose()) / reduced;
  const double depth = reduced / c.z();
  const auto pixelOf = [&](const Eigen::Vector2d& point) {
    return projector_.project(worldFromCamera_ *
                              (depth * Eigen::Vector3d(point.x(), point.y(), 1.0)));
  };
  const auto center = pixelOf(middle);
  const auto right = pixelOf(middle + Eigen::Vector2d(kStep, 0.0));
  const auto down = pixelOf(middle + Eigen::Vector2d(0.0, kStep));
  if (!center || !right || !down) {
    return std::nullopt;
  }
  Eigen::Matrix2d lens;
  lens << (*right - *center) / kStep, (*down - *center) / kStep;
  const Eigen::Matrix2d extent = lens * flat * lens.transpose();
  if (!(extent.determinant() > 0.0)) {
    return std::nullopt;
  }
  return EllipseImage{*center, 0.5 * (extent + extent.transpose())};
}

} // namespace dewpoint::geometry
