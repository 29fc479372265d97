// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::experiment {

/// Parameters of PositionKalmanFilter.
struct KalmanSetup {
  double accelerationSigma =
      6.0; ///< standard deviation of the acceleration between two frames, m/s² per axis
  double startSpeedSigma = 1.0; ///< standard deviation of the initial velocity, m/s per axis
  /// Largest squared Mahalanobis distance at which a measurement is accepted: the 99.9 % quantile
  /// of the chi-square distribution with 3 degrees of freedom.
  double gate = 16.266;
  int restartAfter =
      3; ///< number of successive measurements outside the gate after which the filter restarts
  double lostAfter =
      0.5; ///< time without a measurement after which the target counts as lost, seconds
};

/// Kalman filter with a constant-velocity motion model. It filters measured positions whose
/// covariance is known (Bar-Shalom, Li & Kirubarajan 2001, section 6.3.2: white-noise acceleration,
/// piecewise constant). World frame, meters and seconds.
class PositionKalmanFilter {
public:
  explicit PositionKalmanFilter(const KalmanSetup& setup = {}) : setup_(setup) {}

  /// Returns to the state before the first measurement.
  void reset() { *this = PositionKalmanFilter(setup_); }
  /// Predicts the state `seconds` later.
  void predict(double seconds);
  /// Updates the state with a measured position (m) and its covariance (m²). A position outside the
  /// gate is rejected. The first measurement starts the filter.
  void update(const Eigen::Vector3d& position, const Eigen::Matrix3d& covariance);

  bool isStarted() const { return started_; }
  /// Returns the largest squared Mahalanobis distance at which a measurement is accepted.
  double gate() const { return setup_.gate; }
  Eigen::Vector3d position() const { return state_.head<3>(); }
  Eigen::Vector3d velocity() const { return state_.tail<3>(); }
  Eigen::Matrix3d covariance() const { return covariance_.topLeftCorner<3, 3>(); }

private:
  using State = Eigen::Matrix<double, 6, 1>;
  using StateCovariance = Eigen::Matrix<double, 6, 6>;

  void start(const Eigen::Vector3d& position, const Eigen::Matrix3d& covariance);

  KalmanSetup setup_;
  State state_ = State::Zero();
  StateCovariance covariance_ = StateCovariance::Zero();
  bool started_ = false;
  int rejected_ = 0;
  double sinceMeasurement_ = 0.0;
};

} // namespace dewpoint::experiment
