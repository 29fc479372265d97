// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/gaussian.h"

#include <Eigen/LU>

namespace dewpoint::filter {

void condition(Gaussian6& belief, const Gaussian3& place) {
  const Eigen::Matrix3d prior = belief.covariance.topLeftCorner<3, 3>();
  const Eigen::Matrix3d gain = belief.covariance.bottomLeftCorner<3, 3>() * prior.inverse();
  belief.mean.tail<3>() += gain * (place.mean - belief.mean.head<3>());
  belief.mean.head<3>() = place.mean;
  belief.covariance.bottomRightCorner<3, 3>() -=
      gain * (prior - place.covariance) * gain.transpose();
  belief.covariance.topLeftCorner<3, 3>() = place.covariance;
  belief.covariance.bottomLeftCorner<3, 3>() = gain * place.covariance;
  belief.covariance.topRightCorner<3, 3>() =
      belief.covariance.bottomLeftCorner<3, 3>().transpose().eval();
}

} // namespace dewpoint::filter
