// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::geometry {
namespace {

constexpr int kScanSteps = 8192;
constexpr int kInverseBisections = 100;

/// OpenCV's rational radial factor N(s)/D(s) at the squared normalized radius s.
struct RadialFactor {
  double numerator;
  double denominator;
};

RadialFactor radialFactor(const std::array<double, 8>& k, double s) {
  return {1.0 + s * (k[0] + s * (k[1] + s * k[4])), 1.0 + s * (k[5] + s * (k[6] + s * k[7]))};
}

/// True while the radial model is still one to one at s: no pole, and the sign of d(r N/D)/dr,
/// which is that of (N + 2 s N') D - 2 s N D', is positive.
bool stillGrows(const std::array<double, 8>& k, double s) {
  const auto [n, d] = radialFactor(k, s);
  const double dn = k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]);
  const double dd = k[5] + s * (2.0 * k[6] + s * 3.0 * k[7]);
  return d > 0.0 && (n + 2.0 * s * dn) * d - 2.0 * s * n * dd > 0.0;
}

/// The same for a fisheye: the sign of the derivative of t (1 + k1 t² + ...) by the angle t.
bool stillGrowsFisheye(const std::array<double, 8>& k, double s) {
  const double angle = std::atan(std::sqrt(s));
  const double t = angle * angle;
  return 1.0 + t * (3.0 * k[0] + t * (5.0 * k[1] + t * (7.0 * k[2] + t * 9.0 * k[3]))) > 0.0;
}

/// First squared radius at which the radial model stops growing. The scan is even in the angle off
/// the axis, so it covers every direction in front of the camera.
template <typename Grows>
double foldBackRadiusSquared(const std::array<double, 8>& k, const Grows& stillGrows) {
  double inside = 0.0;
  for (int i = 1; i < kScanSteps; ++i) {
    const double r = std::tan(0.5 * std::numbers::pi * i / kScanSteps);
    double outside = r * r;
    if (stillGrows(k, outside)) {
      inside = outside;
      continue;
    }
    for (int j = 0; j < kInverseBisections; ++j) {
      const double middle = 0.5 * (inside + outside);
      (stillGrows(k, middle) ? inside : outside) = middle;
    }
    return inside;
  }
  return std::numeric_limits<double>::infinity();
}

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

template <bool Distorted> struct ProjectKernel {
  DEWPOINT_KERNEL void run(const Projection* projection, std::int64_t count,
                           const double* __restrict x, const double* __restrict y,
                           const double* __restrict z, double* __restrict column,
                           double* __restrict row) {
    const Projection model = *projection;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto pixel = model.pixel<Distorted>(x[i], y[i], z[i]);
      column[i] = pixel.isVisible ? pixel.column : kNowhere;
      row[i] = pixel.isVisible ? pixel.row : kNowhere;
    }
  }
};

} // namespace

Projector::Projector(const Camera& camera)
    : intrinsics_(camera.intrinsics), lens_(camera.lens), distorted_(camera.hasDistortion()) {
  const Eigen::Isometry3d& pose = camera.cameraFromWorld;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      projection_.rotation[3 * i + j] = pose.linear()(Eigen::Index(i), Eigen::Index(j));
    }
    projection_.translation[i] = pose.translation()[Eigen::Index(i)];
  }
  projection_.focalX = intrinsics_.focalX;
  projection_.focalY = intrinsics_.focalY;
  projection_.centerX = intrinsics_.centerX;
  projection_.centerY = intrinsics_.centerY;
  projection_.distortion = camera.distortion;
  projection_.radiusSquaredLimit = !distorted_ ? std::numeric_limits<double>::infinity()
                                   : lens_ == LensModel::Fisheye
                                       ? foldBackRadiusSquared(camera.distortion, stillGrowsFisheye)
                                       : foldBackRadiusSquared(camera.distortion, stillGrows);
}

std::optional<Eigen::Vector2d> Projector::project(const Eigen::Vector3d& pointWorld) const {
  const double x = pointWorld.x();
  const double y = pointWorld.y();
  const double z = pointWorld.z();
  const Projection::Pixel pixel = lens_ == LensModel::Fisheye ? projection_.fisheyePixel(x, y, z)
                                  : distorted_                ? projection_.pixel<true>(x, y, z)
                                                              : projection_.pixel<false>(x, y, z);
  if (!pixel.isVisible) {
    return std::nullopt;
  }
  return Eigen::Vector2d(pixel.column, pixel.row);
}

void Projector::projectBatch(std::int64_t count, const double* x, const double* y, const double* z,
                             double* column, double* row) const {
  if (lens_ == LensModel::Fisheye) {
    for (std::int64_t i = 0; i < count; ++i) {
      const auto pixel = projection_.fisheyePixel(x[i], y[i], z[i]);
      column[i] = pixel.isVisible ? pixel.column : kNowhere;
      row[i] = pixel.isVisible ? pixel.row : kNowhere;
    }
  } else if (distorted_) {
    runKernel<ProjectKernel<true>>(&projection_, count, x, y, z, column, row);
  } else {
    runKernel<ProjectKernel<false>>(&projection_, count, x, y, z, column, row);
  }
}

} // namespace dewpoint::geometry
