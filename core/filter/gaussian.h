// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Normal distribution with a fixed dimension.
template <int Dimension> struct Gaussian {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Identity();
};
/// Normal distribution of a position: x y z.
using Gaussian3 = Gaussian<3>;
/// Normal distribution of position and velocity: x y z vx vy vz.
using Gaussian6 = Gaussian<6>;

/// Replaces the position of a state by its posterior distribution `position`, and updates the
/// velocity according to its correlation with the position. This equals a Kalman update with the
/// measurement that leads to this posterior.
void conditionOnPosition(Gaussian6& state, const Gaussian3& position);

} // namespace dewpoint::filter
