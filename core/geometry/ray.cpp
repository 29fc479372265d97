// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/ray.h"

#include "core/geometry/projector.h"
#include "core/geometry/small_matrices.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::geometry {
namespace {

constexpr int kNewtonSteps = 50;
constexpr int kHalvings = 30;
constexpr double kDifference = 1e-6; // normalized coordinates; only the speed depends on it
constexpr double kResidual = 1e-9;   // pixels
constexpr double kRounding = 1e3;    // kResiduals that rounding leaves in a very large image
/// Smallest eigenvalue of sum (I - d d') for two rays at angle a is 1 - cos a: 1.5e-6 at 0.1
/// degrees.
constexpr double kParallel = 1.5e-6;

std::optional<Eigen::Vector2d> seen(const Projector& lens, const Eigen::Vector2d& normalized) {
  return lens.project({normalized.x(), normalized.y(), 1.0});
}

/// Derivative of the pixel by the normalized coordinates, by central differences.
std::optional<Eigen::Matrix2d> derivative(const Projector& lens, const Eigen::Vector2d& at) {
  Eigen::Matrix2d result;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kDifference * Eigen::Vector2d::Unit(axis);
    const auto after = seen(lens, at + step);
    const auto before = seen(lens, at - step);
    if (!after || !before) {
      return std::nullopt;
    }
    result.col(axis) = (*after - *before) / (2.0 * kDifference);
  }
  return result;
}

/// A start from which Newton can go: `guess`, or as much of it as the lens model covers.
std::optional<Eigen::Vector2d> start(const Projector& lens, Eigen::Vector2d guess) {
  for (int k = 0; k < kHalvings; ++k, guess *= 0.5) {
    if (derivative(lens, guess)) {
      return guess;
    }
  }
  return std::nullopt;
}

/// The longest of step, step/2, step/4, ... that brings the pixel closer; nothing if none does.
std::optional<Eigen::Vector2d> stepCloser(const Projector& lens, const Eigen::Vector2d& at,
                                          Eigen::Vector2d step, const Eigen::Vector2d& pixel,
                                          double distance) {
  for (int k = 0; k < kHalvings; ++k, step *= 0.5) {
    const auto there = seen(lens, at + step);
    if (there && (*there - pixel).norm() < distance) {
      return at + step;
    }
  }
  return std::nullopt;
}

/// The angle off the axis, in radians, that a fisheye bends to the normalized radius `bent`.
double unbent(const std::array<double, 8>& k, double bent) {
  double angle = std::min(bent, 1.5);
  for (int step = 0; step < kNewtonSteps; ++step) {
    const double t = angle * angle;
    const double error = angle * (1.0 + t * (k[0] + t * (k[1] + t * (k[2] + t * k[3])))) - bent;
    const double slope =
        1.0 + t * (3.0 * k[0] + t * (5.0 * k[1] + t * (7.0 * k[2] + t * 9.0 * k[3])));
    if (std::abs(error) < 1e-15 || !(slope > 0.0)) {
      break;
    }
    angle -= error / slope;
  }
  return angle;
}

} // namespace

Unprojector::Unprojector(const Camera& camera)
    : intrinsics_(camera.intrinsics), worldFromCamera_(camera.cameraFromWorld.linear().transpose()),
      center_(camera.center()), distorted_(camera.hasDistortion()),
      fisheye_(camera.lens == LensModel::Fisheye), distortion_(camera.distortion),
      lens_(withoutPose(camera)) {}

std::optional<Eigen::Vector2d> Unprojector::normalized(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d pinhole((pixel.x() - intrinsics_.centerX) / intrinsics_.focalX,
                                (pixel.y() - intrinsics_.centerY) / intrinsics_.focalY);
  if (!pinhole.allFinite()) {
    return std::nullopt;
  }
  if (!distorted_) {
    return pinhole;
  }
  Eigen::Vector2d guess = pinhole;
  if (const double bent = pinhole.norm(); fisheye_ && bent > 0.0) {
    const double angle = unbent(distortion_, bent);
    if (!(angle >= 0.0 && angle < 0.5 * std::numbers::pi)) {
      return std::nullopt;
    }
    guess *= std::tan(angle) / bent; // Newton below has only to check it
  }
  auto at = start(lens_, guess);
  for (int k = 0; at && k < kNewtonSteps; ++k) {
    const Eigen::Vector2d error = *seen(lens_, *at) - pixel;
    if (error.norm() < kResidual) {
      return at;
    }
    const auto slope = derivative(lens_, *at);
    if (!slope) {
      return std::nullopt;
    }
    const auto next = stepCloser(lens_, *at, -(slope->inverse() * error), pixel, error.norm());
    if (!next) {
      return error.norm() < kRounding * kResidual ? at : std::nullopt;
    }
    at = next;
  }
  return std::nullopt;
}

std::optional<Eigen::Vector3d> Unprojector::worldDirection(const Eigen::Vector2d& pixel) const {
  const auto place = normalized(pixel);
  if (!place) {
    return std::nullopt;
  }
  return (worldFromCamera_ * Eigen::Vector3d(place->x(), place->y(), 1.0)).normalized();
}

std::optional<Ray> Unprojector::ray(const Eigen::Vector2d& pixel) const {
  const auto direction = worldDirection(pixel);
  return direction ? std::optional(Ray{center_, *direction}) : std::nullopt;
}

std::optional<Eigen::Vector3d> nearestPoint(const std::vector<Ray>& rays) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Ray& ray : rays) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    normal += across;
    right += across * ray.origin;
  }
  const SmallEigen<3> eigen = symmetricEigen3(normal);
  if (rays.size() < 2 || !(eigen.values[0] > kParallel)) {
    return std::nullopt; // one ray alone has the eigenvalue 0
  }
  const Eigen::Vector3d point =
      eigen.vectors * (eigen.vectors.transpose() * right).cwiseQuotient(eigen.values);
  const bool inFront = std::all_of(rays.begin(), rays.end(), [&](const Ray& ray) {
    return (point - ray.origin).dot(ray.direction) > 0.0;
  });
  return inFront ? std::optional(point) : std::nullopt;
}

double distanceToRay(const Ray& ray, const Eigen::Vector3d& point) {
  const Eigen::Vector3d toPoint = point - ray.origin;
  const double along = std::max(0.0, toPoint.dot(ray.direction));
  return (toPoint - along * ray.direction).norm();
}

} // namespace dewpoint::geometry
