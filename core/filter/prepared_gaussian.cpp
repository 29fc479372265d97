// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/prepared_gaussian.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <numbers>

namespace dewpoint::filter {

PreparedGaussian3::PreparedGaussian3(const Gaussian3& gaussian)
    : mean_(gaussian.mean), factor_(gaussian.covariance.llt().matrixL()) {
  const double root = factor_.diagonal().prod();
  inverseFactor_ = factor_.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity());
  logPeak_ = -std::log(root) - 1.5 * std::log(2.0 * std::numbers::pi);
}

} // namespace dewpoint::filter
