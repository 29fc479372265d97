// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dewpoint::filter {

/// Motion model of Mohedano et al. 2009, equations 14 and 15: constant velocity and, in states with
/// color, constant color. Position, velocity and color have independent normal noise. States: x y z
/// (m) vx vy vz (m/s), optionally followed by hue h and saturation s, both in [0, 1], where the hue
/// is circular.
struct PersonMotion {
  double interval = 0.0;       ///< seconds since the last step
  double positionSigma = 0.03; ///< standard deviation, m per step
  double velocitySigma = 0.25; ///< standard deviation, m/s per step
  double colorSigma = 0.005;   ///< standard deviation of h and s, per step

  void predict(StateRows rows, std::uint32_t firstIndex, const RandomStream& stream) const {
    const bool hasColor = rows.cols() >= 8;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      const auto index = firstIndex + static_cast<std::uint32_t>(row);
      const auto positionNoise = stream.normal4(index, 0);
      const auto velocityNoise = stream.normal4(index, 1);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        rows(row, axis) += interval * rows(row, axis + 3) + positionSigma * positionNoise[k];
        rows(row, axis + 3) += velocitySigma * velocityNoise[k];
      }
      if (hasColor) {
        const double hue = rows(row, 6) + colorSigma * positionNoise[3];
        rows(row, 6) = hue - std::floor(hue);
        rows(row, 7) = std::clamp(rows(row, 7) + colorSigma * velocityNoise[3], 0.0, 1.0);
      }
    }
  }
};

/// Motion model of a person on the floor. States: x y vx vy (m, m/s) and height (m). Between two
/// steps, a constant acceleration, drawn at random, acts on x and y. The height changes little and
/// returns slowly to `meanHeight`.
struct WalkingMotion {
  double interval = 0.0;          ///< seconds since the last step
  double accelerationSigma = 3.0; ///< standard deviation along each axis, m/s²
  /// Height, in meters, to which the height of a person returns slowly.
  double meanHeight = 1.72;
  double heightSigma = 0.01; ///< standard deviation, m per step

  void predict(StateRows rows, std::uint32_t firstIndex, const RandomStream& stream) const {
    constexpr double kHeightReturnShare = 0.02; // share of the difference, per step
    const double halfSquaredInterval = 0.5 * interval * interval;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      const auto normal = stream.normal4(firstIndex + static_cast<std::uint32_t>(row));
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double acceleration = accelerationSigma * normal[static_cast<std::size_t>(axis)];
        rows(row, axis) += interval * rows(row, axis + 2) + halfSquaredInterval * acceleration;
        rows(row, axis + 2) += interval * acceleration;
      }
      rows(row, 4) += kHeightReturnShare * (meanHeight - rows(row, 4)) + heightSigma * normal[2];
    }
  }
};

} // namespace dewpoint::filter
