// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cmath>

namespace dewpoint::geometry {

/// Model of lens distortion, without its coefficients.
enum class LensModel {
  Pinhole, ///< OpenCV's rational radial and tangential distortion: k1 k2 p1 p2 k3 k4 k5 k6
  Fisheye  ///< OpenCV's cv::fisheye (Kannala and Brandt 2006, odd powers of the angle): k1 k2 k3 k4
};

/// OpenCV's camera models as plain numbers, for loops over many points. Created by Projector.
struct Projection {
  std::array<double, 9> rotation{};    ///< camera from world, row by row
  std::array<double, 3> translation{}; ///< camera from world, meters
  double focalX = 0.0, focalY = 0.0, centerX = 0.0, centerY = 0.0; ///< pixels
  std::array<double, 8> distortion{}; ///< distortion coefficients in the order of the lens model
  /// Largest squared normalized radius at which the distorted radius still increases. The
  /// normalized radius of a point is its distance from the optical axis divided by its depth.
  double radiusSquaredLimit = 0.0;

  /// Minimum depth in front of the camera, meters. Nearer points are not projected.
  static constexpr double kMinDepth = 1e-9;

  /// Projected point, pixels.
  struct Pixel {
    double column;
    double row;
    bool isVisible; ///< in front of the camera and within the valid angle of the distortion
  };

  /// Projects the world point (x, y, z), meters, with LensModel::Pinhole. `Distorted` is false to
  /// skip the distortion terms. The function has no branches, so that loops over calls can be
  /// vectorized. Column and row are meaningless if the point is not visible.
  template <bool Distorted> [[gnu::always_inline]] Pixel pixel(double x, double y, double z) const {
    const auto& r = rotation;
    const double xCamera = r[0] * x + r[1] * y + r[2] * z + translation[0];
    const double yCamera = r[3] * x + r[4] * y + r[5] * z + translation[1];
    const double zCamera = r[6] * x + r[7] * y + r[8] * z + translation[2];
    bool isVisible = zCamera > kMinDepth; // also false for NaN
    const double inverseDepth = 1.0 / zCamera;
    double u = xCamera * inverseDepth;
    double v = yCamera * inverseDepth;
    if constexpr (Distorted) {
      const auto& k = distortion;
      const double radiusSquared = u * u + v * v;
      isVisible = isVisible & (radiusSquared <= radiusSquaredLimit);
      const double numerator =
          1.0 + radiusSquared * (k[0] + radiusSquared * (k[1] + radiusSquared * k[4]));
      const double denominator =
          1.0 + radiusSquared * (k[5] + radiusSquared * (k[6] + radiusSquared * k[7]));
      const double radialFactor = numerator / denominator;
      const double du = 2.0 * k[2] * u * v + k[3] * (radiusSquared + 2.0 * u * u);
      const double dv = k[2] * (radiusSquared + 2.0 * v * v) + 2.0 * k[3] * u * v;
      u = u * radialFactor + du;
      v = v * radialFactor + dv;
    }
    return {focalX * u + centerX, focalY * v + centerY, isVisible};
  }

  /// Projects the world point (x, y, z), meters, with LensModel::Fisheye. A point at angle t from
  /// the optical axis appears at the normalized radius t (1 + k1 t² + k2 t⁴ + k3 t⁶ + k4 t⁸).
  Pixel fisheyePixel(double x, double y, double z) const {
    const auto& r = rotation;
    const double xCamera = r[0] * x + r[1] * y + r[2] * z + translation[0];
    const double yCamera = r[3] * x + r[4] * y + r[5] * z + translation[1];
    const double zCamera = r[6] * x + r[7] * y + r[8] * z + translation[2];
    const double u = xCamera / zCamera;
    const double v = yCamera / zCamera;
    const double radiusSquared = u * u + v * v;
    const bool isVisible =
        zCamera > kMinDepth && radiusSquared <= radiusSquaredLimit; // also false for NaN
    const double radius = std::sqrt(radiusSquared);
    const double angle = std::atan(radius);
    const double angleSquared = angle * angle;
    const auto& k = distortion;
    const double distortedAngle =
        angle *
        (1.0 + angleSquared *
                   (k[0] + angleSquared * (k[1] + angleSquared * (k[2] + angleSquared * k[3]))));
    const double radialFactor = radius > 1e-8 ? distortedAngle / radius : 1.0;
    return {focalX * u * radialFactor + centerX, focalY * v * radialFactor + centerY, isVisible};
  }
};

} // namespace dewpoint::geometry
