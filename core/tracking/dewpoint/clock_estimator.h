// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/observation/sphere/outline_fit.h"
#include "core/tracking/clock_estimate.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::tracking {

/// Estimates the delays of the cameras' time stamps during tracking, from the motion of targets.
///
/// If the images of a camera are late, a moving target appears in this camera behind its position
/// in the other cameras, by its velocity times the delay. Errors of the calibration also displace
/// the target, but independently of its velocity. A Kalman filter (in information form) separates
/// the two effects. The state of the filter consists of five numbers per camera: the delay, its
/// drift, the time that the shutter takes from the first row of an image to the last row, and two
/// angles by which the target appears displaced. The angles change as the target moves through the
/// image, because the calibration error differs from place to place.
class ClockEstimator {
public:
  explicit ClockEstimator(const CameraRig& rig);

  /// Sets another calibration of the same cameras. If the calibration changes, all estimates are
  /// discarded, because they depend on the errors of the calibration.
  void setCameras(const CameraRig& rig);

  /// Assumptions that apply before any motion is seen.
  struct Prior {
    double delaySigma = 0.0;     ///< seconds; 0: all time stamps are exact
    double directionSigma = 0.0; ///< radians, error of the directions in which cameras see objects
  };
  /// Sets the prior. If the prior changes, all estimates are discarded.
  void setPrior(const Prior& prior);
  /// Discards all estimates.
  void restart();

  /// Moving target in a frame. World frame, meters.
  struct Sighting {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s
    /// Information about the position from each camera, computed with the delays from delays().
    const std::vector<CameraInformation>* cameraInformation = nullptr;
    double weight = 1.0; ///< factor of the information, 0 to 1; 0 if the cameras do not agree
  };
  /// Learns from the targets seen in a frame, `interval` seconds after the previous frame.
  void learn(const std::vector<Sighting>& sightings, double interval);

  /// Returns the estimates relative to the first camera, one per camera.
  std::vector<ClockEstimate> estimates() const;
  /// Returns the estimated delay in seconds of each camera, for the center row of its images. Only
  /// differences between cameras can be estimated, so the mean over the cameras is about 0.
  std::vector<double> delays() const;
  /// Returns the estimated delay in seconds of each camera, for the image row that shows a position
  /// (meters, world frame).
  std::vector<double> delaysAt(const Eigen::Vector3d& position) const;

private:
  static constexpr Eigen::Index kStates = 5; ///< per camera: delay, drift, shutter, two angles

  /// Returns the row in which a camera shows a position (meters, world frame), as a fraction of the
  /// image height from the center row: -0.5 in the first row, 0.5 in the last row. Returns 0 if the
  /// camera cannot see the position.
  double rowShare(std::size_t camera, const Eigen::Vector3d& position) const;
  bool isActive() const { return prior_.delaySigma > 0.0 && rig_.size() > 1; }
  void add(const Sighting& sighting);
  void predict();
  void update();

  CameraRig rig_;
  std::vector<Projector> projectors_;
  Prior prior_;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  /// Information from the frames since the last update, about the complete state.
  Eigen::MatrixXd information_;
  Eigen::VectorXd informationVector_;
  /// Running mean of how many of the moving targets the cameras agree about, 0 to 1.
  double agreeing_ = 0.0;
  double elapsed_ = 0.0;       ///< seconds since the last update
  int frames_ = 0;             ///< frames since the last update
  std::vector<double> turned_; ///< radians that the fastest target moved in each camera since then
};

} // namespace dewpoint::tracking
