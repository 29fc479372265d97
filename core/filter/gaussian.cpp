// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/gaussian.h"

#include <Eigen/LU>

namespace dewpoint::filter {

void conditionOnPosition(Gaussian6& state, const Gaussian3& position) {
  const Eigen::Matrix3d prior = state.covariance.topLeftCorner<3, 3>();
  const Eigen::Matrix3d gain = state.covariance.bottomLeftCorner<3, 3>() * prior.inverse();
  state.mean.tail<3>() += gain * (position.mean - state.mean.head<3>());
  state.mean.head<3>() = position.mean;
  state.covariance.bottomRightCorner<3, 3>() -=
      gain * (prior - position.covariance) * gain.transpose();
  state.covariance.topLeftCorner<3, 3>() = position.covariance;
  state.covariance.bottomLeftCorner<3, 3>() = gain * position.covariance;
  state.covariance.topRightCorner<3, 3>() =
      state.covariance.bottomLeftCorner<3, 3>().transpose().eval();
}

} // namespace dewpoint::filter
