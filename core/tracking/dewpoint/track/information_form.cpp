// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/information_form.h"

#include "core/tracking/dewpoint/track/track_constants.h"

#include <Eigen/LU>

namespace dewpoint::tracking {

InformationForm InformationForm::measurementBetween(const Gaussian3& before, const Gaussian3& after,
                                                    double variance) {
  const Eigen::Matrix3d known = after.covariance.inverse();
  Eigen::Matrix3d own = known - before.covariance.inverse();
  own = 0.5 * (own + own.transpose().eval());
  own.diagonal().array() += kMinInformation;
  // (own^-1 + variance I)^-1
  const Eigen::Matrix3d shrink = (Eigen::Matrix3d::Identity() + variance * own).inverse();
  const Eigen::Matrix3d information = shrink * own;
  return {0.5 * (information + information.transpose()),
          shrink * (known * (after.mean - before.mean))};
}

Gaussian3 InformationForm::asGaussian(const Eigen::Vector3d& predicted) const {
  Gaussian3 result;
  const Eigen::Matrix3d covariance = information.inverse();
  result.covariance = 0.5 * (covariance + covariance.transpose());
  result.mean = predicted + result.covariance * vector;
  return result;
}

Gaussian3 InformationForm::posterior(const Gaussian3& before) const {
  Gaussian3 result;
  const Eigen::Matrix3d covariance = (before.covariance.inverse() + information).inverse();
  result.covariance = 0.5 * (covariance + covariance.transpose());
  result.mean = before.mean + result.covariance * vector;
  return result;
}

double InformationForm::squaredMahalanobisDistance(const Eigen::Matrix3d& before) const {
  const Eigen::Matrix3d spread = information * before * information + information;
  return vector.dot(spread.inverse() * vector);
}

} // namespace dewpoint::tracking
