// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/prepared_gaussian.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace dewpoint::filter {

PreparedGaussian3::PreparedGaussian3(const Gaussian3& gaussian)
    : mean_(gaussian.mean), factor_(gaussian.covariance.llt().matrixL()) {
  const double root = factor_.diagonal().prod();
  inverseFactor_ = factor_.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity());
  logPeak_ = -std::log(root) - 1.5 * std::log(2.0 * std::numbers::pi);
}

Eigen::ArrayXXd PreparedGaussian3::draw(Eigen::Index count, const RandomStream& stream) const {
  Eigen::ArrayXXd samples(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto normal = stream.normal4(static_cast<std::uint32_t>(i));
    samples.row(i) = fromStandardNormal({normal[0], normal[1], normal[2]}).transpose();
  }
  return samples;
}

} // namespace dewpoint::filter
