// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/gaussian.h"
#include "core/filter/particle_set.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint::filter {

/// Motion model with nearly constant velocity. States are x y z vx vy vz (meters and meters per
/// second). Between two steps, a constant acceleration, drawn at random, acts on each axis
/// (discrete white noise acceleration model: Bar-Shalom, Li and Kirubarajan 2001, section 6.3.2).
struct ConstantVelocity {
  double interval = 0.0;          ///< seconds since the last step
  double accelerationSigma = 0.0; ///< standard deviation along each axis, m/s²

  /// Moves particles by one step. `firstIndex` is the index of the first row in the whole set.
  void predict(StateRows rows, std::uint32_t firstIndex, const RandomStream& stream) const {
    const double halfSquaredInterval = 0.5 * interval * interval;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      const auto normal = stream.normal4(firstIndex + static_cast<std::uint32_t>(row));
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double acceleration = accelerationSigma * normal[static_cast<std::size_t>(axis)];
        rows(row, axis) += interval * rows(row, axis + 3) + halfSquaredInterval * acceleration;
        rows(row, axis + 3) += interval * acceleration;
      }
    }
  }

  /// Predicts a Gaussian by one step, as a Kalman filter does.
  void predict(Gaussian6& state) const {
    using Matrix6 = Gaussian6::Matrix;
    Matrix6 transition = Matrix6::Identity();
    transition.topRightCorner<3, 3>().diagonal().setConstant(interval);
    state.mean = transition * state.mean;
    state.covariance = transition * state.covariance * transition.transpose();
    const double accelerationVariance = accelerationSigma * accelerationSigma;
    const double t = interval;
    for (int axis = 0; axis < 3; ++axis) {
      state.covariance(axis, axis) += 0.25 * t * t * t * t * accelerationVariance;
      state.covariance(axis, axis + 3) += 0.5 * t * t * t * accelerationVariance;
      state.covariance(axis + 3, axis) += 0.5 * t * t * t * accelerationVariance;
      state.covariance(axis + 3, axis + 3) += t * t * accelerationVariance;
    }
  }
};

} // namespace dewpoint::filter
