// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::experiment {

struct KalmanSetup {
  double accelerationSigma = 6.0; ///< m/s² per axis: what the target may do between two frames
  double startSpeedSigma = 1.0;   ///< m/s per axis
  /// Squared Mahalanobis distance that a measurement may have: 99.9 % of chi-square with 3 degrees
  /// of freedom.
  double gate = 16.266;
  int restartAfter = 3;     ///< measurements outside the gate in a row: believe them, start again
  double forgetAfter = 0.5; ///< seconds without a measurement until the target counts as lost
};

/// Constant-velocity Kalman filter on positions with known covariance (Bar-Shalom, Li &
/// Kirubarajan 2001, section 6.3.2: white-noise acceleration, piecewise constant). World frame,
/// meters and seconds.
class KalmanPoint {
public:
  explicit KalmanPoint(const KalmanSetup& setup = {}) : setup_(setup) {}

  void forget() { *this = KalmanPoint(setup_); }
  /// Predicts `seconds` ahead.
  void predict(double seconds);
  /// Takes a measurement, unless it is outside the gate; starts with the first one.
  void update(const Eigen::Vector3d& position, const Eigen::Matrix3d& covariance);

  bool started() const { return started_; }
  /// Squared Mahalanobis distance that a measurement may have.
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
