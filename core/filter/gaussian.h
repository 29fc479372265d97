// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// A normal distribution of fixed dimension.
template <int Dimension> struct Gaussian {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Identity();
};
using Gaussian3 = Gaussian<3>;
/// Position and velocity: x y z vx vy vz.
using Gaussian6 = Gaussian<6>;

/// Replaces what a belief says about the place by a better informed one; the velocity follows as
/// far as it is correlated with the place (the update of a Kalman filter, written for a posterior
/// of the observed part).
void condition(Gaussian6& belief, const Gaussian3& place);

} // namespace dewpoint::filter
