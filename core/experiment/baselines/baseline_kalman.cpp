// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_kalman.h"

#include <Eigen/Cholesky>

namespace dewpoint::experiment {

void PositionKalmanFilter::start(const Eigen::Vector3d& position,
                                 const Eigen::Matrix3d& covariance) {
  state_ << position, Eigen::Vector3d::Zero();
  covariance_.setZero();
  covariance_.topLeftCorner<3, 3>() = covariance;
  covariance_.bottomRightCorner<3, 3>() =
      setup_.startSpeedSigma * setup_.startSpeedSigma * Eigen::Matrix3d::Identity();
  started_ = true;
  rejected_ = 0;
  sinceMeasurement_ = 0.0;
}

void PositionKalmanFilter::predict(double seconds) {
  if (!started_) {
    return;
  }
  sinceMeasurement_ += seconds;
  if (sinceMeasurement_ > setup_.lostAfter) {
    reset();
    return;
  }
  StateCovariance transition = StateCovariance::Identity();
  transition.topRightCorner<3, 3>() = seconds * Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 6, 3> push;
  push << 0.5 * seconds * seconds * Eigen::Matrix3d::Identity(),
      seconds * Eigen::Matrix3d::Identity();
  state_ = transition * state_;
  covariance_ = transition * covariance_ * transition.transpose() +
                setup_.accelerationSigma * setup_.accelerationSigma * push * push.transpose();
}

void PositionKalmanFilter::update(const Eigen::Vector3d& position,
                                  const Eigen::Matrix3d& covariance) {
  if (!started_) {
    start(position, covariance);
    return;
  }
  const Eigen::Vector3d innovation = position - state_.head<3>();
  const Eigen::LDLT<Eigen::Matrix3d> spread(covariance_.topLeftCorner<3, 3>() + covariance);
  if (innovation.dot(spread.solve(innovation)) > setup_.gate) {
    if (++rejected_ >= setup_.restartAfter) {
      start(position, covariance);
    }
    return;
  }
  rejected_ = 0;
  sinceMeasurement_ = 0.0;
  const Eigen::Matrix<double, 6, 3> gain = spread.solve(covariance_.topRows<3>()).transpose();
  state_ += gain * innovation;
  // Joseph's form keeps the covariance symmetric and positive.
  StateCovariance keep = StateCovariance::Identity();
  keep.leftCols<3>() -= gain;
  covariance_ = keep * covariance_ * keep.transpose() + gain * covariance * gain.transpose();
}

} // namespace dewpoint::experiment
