// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/clock_estimator.h"

#include "core/geometry/linear_algebra.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 13.

/// Seconds per second, standard deviation of the drift: frame rates that are rounded (29.97 as 30)
/// are off by 0.1 %, the clocks of cameras by less than a tenth of that.
constexpr double kDriftSigma = 5e-4;
/// Seconds per root of a second, random walk of the delay: what drivers buffer changes slowly.
constexpr double kDelayWalk = 2e-4;
/// Seconds, standard deviation of the time from the first row to the last: rolling shutters take
/// most of the time between two images, 15 to 30 ms, global shutters none.
constexpr double kShutterSigma = 0.02;
/// Part of the step of a delay that may be an error of the step itself: while the images of cameras
/// are far apart, edges are left out, and the fit says less than the whole distance.
constexpr double kStepShare = 1.0;
/// Radians that a target moves in an image until the error of its direction there has little to do
/// with the one before: about half of the image of a usual camera.
constexpr double kDirectionReach = 0.5;
/// Successive frames whose errors are nearly the same, because shade, blur and background are: they
/// count as one.
constexpr double kCorrelatedFrames = 4.0;
/// Gain of the running mean of how many targets the cameras agree about, per frame: 1 s at 30 Hz.
constexpr double kAgreementGain = 1.0 / 30.0;
/// Least share of moving targets about which the cameras must agree. If they are too far apart in
/// time, they agree only where the target is slow, and the delays found there are too small.
constexpr double kLeastAgreeing = 0.8;
/// Frames between two updates: nothing changes much in between, and inverting the covariance of
/// many cameras costs more than a frame.
constexpr int kFramesPerUpdate = 5;
/// Least standard deviation of the error of a direction, radians: a lens is never known better.
constexpr double kLeastDirectionSigma = 2e-4;

Eigen::Index firstState(std::size_t camera, Eigen::Index statesPerCamera) {
  return static_cast<Eigen::Index>(camera) * statesPerCamera;
}

/// Two directions across a ray, about along the columns and rows of the camera's image.
Eigen::Matrix<double, 3, 2> across(const Camera& camera, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d down = camera.cameraFromWorld.linear().row(1).transpose();
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = down.cross(ray).normalized();
  axes.col(1) = ray.cross(axes.col(0)).normalized();
  return axes;
}

/// Radians per second, largest of the targets as seen from a camera. Several targets that move at
/// the same time do not move farther through the image than the fastest one.
double largestAngularSpeed(const std::vector<ClockEstimator::Sighting>& sightings,
                           const Eigen::Vector3d& camera) {
  double largest = 0.0;
  for (const ClockEstimator::Sighting& sighting : sightings) {
    const double distance = std::max(1e-3, (sighting.position - camera).norm());
    largest = std::max(largest, sighting.velocity.norm() / distance);
  }
  return largest;
}

} // namespace

ClockEstimator::ClockEstimator(const CameraRig& rig)
    : rig_(rig), projectors_(rig.begin(), rig.end()) {
  restart();
}

void ClockEstimator::setCameras(const CameraRig& rig) {
  if (rig != rig_) {
    rig_ = rig;
    projectors_ = std::vector<Projector>(rig.begin(), rig.end());
    restart();
  }
}

void ClockEstimator::setPrior(const Prior& prior) {
  if (prior.delaySigma != prior_.delaySigma || prior.directionSigma != prior_.directionSigma) {
    prior_ = prior;
    restart();
  }
}

void ClockEstimator::restart() {
  const Eigen::Index size = isActive() ? firstState(rig_.size(), kStates) : 0;
  mean_ = Eigen::VectorXd::Zero(size);
  covariance_ = Eigen::MatrixXd::Zero(size, size);
  information_ = Eigen::MatrixXd::Zero(size, size);
  informationVector_ = Eigen::VectorXd::Zero(size);
  agreeing_ = 0.0;
  elapsed_ = 0.0;
  frames_ = 0;
  turned_.assign(rig_.size(), 0.0);
  const double direction = std::max(prior_.directionSigma, kLeastDirectionSigma);
  for (Eigen::Index k = 0; k < size; k += kStates) {
    covariance_.diagonal().segment<kStates>(k) =
        (Eigen::Vector<double, kStates>() << prior_.delaySigma, kDriftSigma, kShutterSigma,
         direction, direction)
            .finished()
            .array()
            .square();
  }
}

void ClockEstimator::learn(const std::vector<Sighting>& sightings, double interval) {
  if (!isActive()) {
    return;
  }
  elapsed_ += interval;
  for (const Sighting& sighting : sightings) {
    agreeing_ += kAgreementGain * ((sighting.weight > 0.0 ? 1.0 : 0.0) - agreeing_);
    if (sighting.weight > 0.0) {
      add(sighting);
    }
  }
  for (std::size_t k = 0; k < rig_.size(); ++k) {
    turned_[k] += interval * largestAngularSpeed(sightings, rig_[k].center());
  }
  if (++frames_ >= kFramesPerUpdate) {
    predict();
    update();
  }
}

void ClockEstimator::add(const Sighting& sighting) {
  const std::vector<CameraInformation>& pulls = *sighting.cameraInformation;
  Eigen::Matrix3d total = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  int seeing = 0;
  for (const CameraInformation& one : pulls) {
    total += one.information;
    pull += one.vector;
    seeing += one.information.isZero(0.0) ? 0 : 1;
  }
  if (seeing < 2) {
    return; // one camera alone always agrees with itself
  }
  // Camera k sees the target displaced by d + J_k s_k: d is the error of the position, which all
  // cameras share and which is eliminated.
  const Eigen::Matrix3d eliminated = total.inverse();
  if (!eliminated.allFinite()) {
    return;
  }
  const Eigen::Index size = mean_.size();
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(size, 3);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd corrected = Eigen::VectorXd::Zero(size); // what the pulls already contain
  for (std::size_t k = 0; k < pulls.size(); ++k) {
    if (pulls[k].information.isZero(0.0)) {
      continue;
    }
    const Eigen::Vector3d ray = sighting.position - rig_[k].center();
    Eigen::Matrix<double, 3, kStates> jacobian = Eigen::Matrix<double, 3, kStates>::Zero();
    const double share = rowShare(k, sighting.position);
    jacobian.col(0) = -sighting.velocity;
    jacobian.col(2) = -share * sighting.velocity;
    jacobian.rightCols<2>() = ray.norm() * across(rig_[k], ray);
    const Eigen::Index first = firstState(k, kStates);
    const Eigen::Matrix<double, kStates, 3> weighted = jacobian.transpose() * pulls[k].information;
    shared.middleRows<kStates>(first) = weighted;
    information.block<kStates, kStates>(first, first) = weighted * jacobian;
    vector.segment<kStates>(first) = jacobian.transpose() * pulls[k].vector;
    corrected[first] = mean_[first];
    corrected[first + 2] = mean_[first + 2];
  }
  information -= shared * eliminated * shared.transpose();
  vector -= shared * (eliminated * pull);
  const double trust = sighting.weight / kCorrelatedFrames;
  information_ += trust * information;
  informationVector_ += trust * (vector + information * corrected);
}

void ClockEstimator::predict() {
  const double direction = std::max(prior_.directionSigma, kLeastDirectionSigma);
  Eigen::MatrixXd transition = Eigen::MatrixXd::Identity(mean_.size(), mean_.size());
  Eigen::VectorXd noise = Eigen::VectorXd::Zero(mean_.size());
  for (std::size_t k = 0; k < rig_.size(); ++k) {
    const Eigen::Index first = firstState(k, kStates);
    transition(first, first + 1) = elapsed_;
    noise[first] = kDelayWalk * kDelayWalk * elapsed_;
    const double kept = std::exp(-turned_[k] / kDirectionReach);
    transition(first + 3, first + 3) = transition(first + 4, first + 4) = kept;
    noise.segment<2>(first + 3).setConstant(direction * direction * (1.0 - kept * kept));
  }
  mean_ = transition * mean_;
  covariance_ = transition * covariance_ * transition.transpose();
  covariance_.diagonal() += noise;
}

void ClockEstimator::update() {
  const Eigen::MatrixXd before = geometry::inverse(covariance_);
  const geometry::SymmetricFactorization after(before + information_);
  if (after.isPositiveDefinite()) {
    const Eigen::VectorXd last = mean_;
    mean_ = after.solve(before * last + informationVector_);
    covariance_ = after.solve(Eigen::MatrixXd::Identity(mean_.size(), mean_.size()));
    for (Eigen::Index k = 0; k < mean_.size(); k += kStates) {
      const double step = kStepShare * (mean_[k] - last[k]);
      covariance_(k, k) += step * step;
    }
  }
  information_.setZero();
  informationVector_.setZero();
  elapsed_ = 0.0;
  frames_ = 0;
  std::ranges::fill(turned_, 0.0);
}

std::vector<ClockEstimate> ClockEstimator::estimates() const {
  std::vector<ClockEstimate> all(rig_.size());
  for (std::size_t k = 1; isActive() && k < rig_.size(); ++k) {
    const Eigen::Index first = firstState(k, kStates);
    // The first states of all are those of the first camera.
    const auto sigma = [&](Eigen::Index state) {
      const Eigen::Index own = first + state;
      return std::sqrt(std::max(0.0, covariance_(own, own) - 2.0 * covariance_(own, state) +
                                         covariance_(state, state)));
    };
    const double least = agreeing_ < kLeastAgreeing ? prior_.delaySigma : 0.0;
    all[k] = {mean_[first] - mean_[0], std::max(sigma(0), least), mean_[first + 1] - mean_[1],
              sigma(1)};
  }
  return all;
}

std::vector<double> ClockEstimator::delays() const {
  std::vector<double> delays(rig_.size(), 0.0);
  for (std::size_t k = 0; isActive() && k < rig_.size(); ++k) {
    delays[k] = mean_[firstState(k, kStates)];
  }
  return delays;
}

std::vector<double> ClockEstimator::delaysAt(const Eigen::Vector3d& position) const {
  std::vector<double> delays(rig_.size(), 0.0);
  for (std::size_t k = 0; isActive() && k < rig_.size(); ++k) {
    const Eigen::Index first = firstState(k, kStates);
    delays[k] = mean_[first] + mean_[first + 2] * rowShare(k, position);
  }
  return delays;
}

double ClockEstimator::rowShare(std::size_t camera, const Eigen::Vector3d& position) const {
  const auto pixel = projectors_[camera].project(position);
  const double height = projectors_[camera].intrinsics().height;
  return pixel ? std::clamp((pixel->y() + 0.5) / height, 0.0, 1.0) - 0.5 : 0.0;
}

} // namespace dewpoint::tracking
