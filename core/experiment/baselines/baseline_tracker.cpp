// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_tracker.h"

#include "core/color/match_image.h"

#include <algorithm>
#include <utility>

namespace dewpoint::experiment {
namespace {

// Where a target is expected. Judgments, not tuned; those of the start are what method `dewpoint`
// takes of the same volume (search_prior.cpp).

/// Standard deviation of the first position, as a share of the start volume's half size: of two
/// objects that look the same, the one nearer to the center is meant.
/// Chosen: the volume's border is at two standard deviations.
constexpr double kStartShare = 0.5;
/// Meters; its least value, for a start at a point; chosen: somebody points at a target roughly.
constexpr double kLeastStartSigma = 0.05;
/// m/s per axis: how far a target is from where it was last, for each second that has passed.
/// Chosen: the fast paths of the suite are about as fast.
constexpr double kSpeedSigma = 1.0;
/// Meters per axis; its least value: the error of a position.
constexpr double kLeastStepSigma = 0.01;

Eigen::Matrix3d squared(const Eigen::Vector3d& sigmas) {
  return sigmas.array().square().matrix().asDiagonal();
}

} // namespace

BaselineTracker::BaselineTracker(const BaselineSetup& setup, const CameraRig& rig,
                                 std::vector<Target> targets, const StartVolume& start)
    : setup_(setup), pairing_(rig), cameraCount_(rig.size()), targets_(std::move(targets)),
      start_(start) {
  restart(0);
}

void BaselineTracker::setCameras(const CameraRig& rig) {
  if (rig.size() == cameraCount_) {
    pairing_ = BlobPairing(rig);
  }
}

void BaselineTracker::setTargets(const std::vector<Target>& targets) {
  if (targets.size() == targets_.size()) {
    targets_ = targets;
  }
}

void BaselineTracker::restart(std::uint64_t) {
  tracked_.clear();
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    tracked_.push_back({CameraFollowers(setup_.followerFactory, cameraCount_),
                        PositionKalmanFilter(), std::nullopt, 0.0});
  }
  estimates_.assign(targets_.size(), SphereEstimate{});
  time_.reset();
}

void BaselineTracker::iterate(ThreadTeam&) {
  if (!frames_) {
    return;
  }
  predict();
  MeasuredPositions measured(targets_.size());
  for (const TargetIndices& members : groups()) {
    measure(members, measured);
  }
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    updateEstimate(k, measured[k]);
  }
}

void BaselineTracker::predict() {
  const double elapsed = time_ ? seconds(frames_->time - *time_) : 0.0;
  time_ = frames_->time;
  for (Tracked& tracked : tracked_) {
    tracked.secondsSinceSeen += std::max(0.0, elapsed);
    if (setup_.usesKalmanFilter && elapsed > 0.0) {
      tracked.filter.predict(elapsed);
    }
    if (setup_.usesKalmanFilter && tracked.filter.isStarted()) {
      tracked.lastPosition = tracked.filter.position();
    }
  }
}

/// The targets by what they look like.
std::vector<BaselineTracker::TargetIndices> BaselineTracker::groups() const {
  std::vector<TargetIndices> groups;
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const auto same = std::ranges::find_if(groups, [&](const TargetIndices& members) {
      const Target& first = targets_[members.front()];
      return first.colors() == targets_[k].colors() && first.radius == targets_[k].radius;
    });
    if (same == groups.end()) {
      groups.push_back({k});
    } else {
      same->push_back(k);
    }
  }
  return groups;
}

BaselineTracker::ImagesAndBlobs BaselineTracker::viewsOf(const ColorRanges& color) const {
  const ColorClassifier classifier(color);
  ImagesAndBlobs views{std::vector<CameraImages>(cameraCount_),
                       std::vector<CameraBlobs>(cameraCount_)};
  for (std::size_t camera = 0; camera < std::min(cameraCount_, frames_->frames.size()); ++camera) {
    if (const FramePtr& frame = frames_->frames[camera]) {
      views.images[camera] = {frame->image, matchImage(frame->image, classifier)};
      views.blobs[camera] = {true, findBlobs(views.images[camera].mask)};
    }
  }
  return views;
}

void BaselineTracker::measure(const TargetIndices& members, MeasuredPositions& measured) {
  const Target& target = targets_[members.front()];
  const ImagesAndBlobs views = viewsOf(target.colors());
  const TargetIndices open = follow(members, views, measured);
  if (open.empty()) {
    return;
  }
  auto pairs = pairing_.pairBlobs(views.blobs, target.radius, members.size());
  for (const std::size_t k : members) {
    if (measured[k]) { // what its followers hold is no other target
      std::erase_if(pairs, [&](const PairedBlobs& pair) {
        return relativeResidual(pair.point.bearings, measured[k]->position) <= 1.0;
      });
    }
  }
  assignBlobs(open, views, pairs, measured);
}

/// Measures those whose followers agree; returns the others.
BaselineTracker::TargetIndices BaselineTracker::follow(const TargetIndices& members,
                                                       const ImagesAndBlobs& views,
                                                       MeasuredPositions& measured) {
  if (setup_.followerFactory == nullptr) {
    return members;
  }
  TargetIndices open;
  for (const std::size_t k : members) {
    measured[k] = triangulateFollowers(tracked_[k], views);
    if (measured[k]) {
      startMissingFollowers(k, views, measured[k]->position);
    } else {
      open.push_back(k);
    }
  }
  return open;
}

std::optional<TriangulatedPoint>
BaselineTracker::triangulateFollowers(Tracked& tracked, const ImagesAndBlobs& views) const {
  const auto pixels = tracked.followers.step(views.images);
  std::vector<Bearing> bearings;
  for (std::size_t camera = 0; camera < pixels.size(); ++camera) {
    const auto& pixel = pixels[camera];
    const auto bearing =
        pixel ? pairing_.makeBearing(camera, 0, pixel->center, pixel->radiusPx) : std::nullopt;
    if (bearing) {
      bearings.push_back(*bearing);
    }
  }
  auto point = triangulate(std::move(bearings));
  const bool agreed = point && relativeResidual(point->bearings, point->position) <= 1.0;
  return agreed ? std::move(point) : std::nullopt;
}

void BaselineTracker::startMissingFollowers(std::size_t target, const ImagesAndBlobs& views,
                                            const Eigen::Vector3d& position) {
  CameraFollowers& followers = tracked_[target].followers;
  for (std::size_t camera = 0; camera < cameraCount_; ++camera) {
    const std::vector<Blob>& blobs = views.blobs[camera].blobs;
    if (followers.hasFollower(camera) || blobs.empty()) {
      continue;
    }
    if (const auto blob = pairing_.blobAt(camera, blobs, position, targets_[target].radius)) {
      followers.start(camera, views.images[camera], blobs[*blob].box);
    }
  }
}

void BaselineTracker::assignBlobs(const TargetIndices& members, const ImagesAndBlobs& views,
                                  const std::vector<PairedBlobs>& pairs,
                                  MeasuredPositions& measured) {
  std::vector<ExpectedPosition> expected;
  expected.reserve(members.size());
  for (const std::size_t k : members) {
    expected.push_back(expectedPositionOf(tracked_[k]));
  }
  auto found = assignPairs(pairs, expected);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!found[i]) {
      continue;
    }
    CameraFollowers& followers = tracked_[members[i]].followers;
    followers.clear();
    for (const Bearing& bearing : found[i]->bearings) {
      followers.start(bearing.camera, views.images[bearing.camera],
                      views.blobs[bearing.camera].blobs[bearing.blob].box);
    }
    measured[members[i]] = std::move(found[i]);
  }
}

ExpectedPosition BaselineTracker::expectedPositionOf(const Tracked& tracked) const {
  if (setup_.usesKalmanFilter && tracked.filter.isStarted()) {
    return {tracked.filter.position(), tracked.filter.covariance(), tracked.filter.gate()};
  }
  if (tracked.lastPosition) {
    const double sigma = std::max(kLeastStepSigma, kSpeedSigma * tracked.secondsSinceSeen);
    return {*tracked.lastPosition, squared(Eigen::Vector3d::Constant(sigma)), std::nullopt};
  }
  const Eigen::Vector3d sigmas = (kStartShare * start_.halfSize).cwiseMax(kLeastStartSigma);
  return {start_.center, squared(sigmas), std::nullopt};
}

void BaselineTracker::updateEstimate(std::size_t target,
                                     const std::optional<TriangulatedPoint>& position) {
  Tracked& tracked = tracked_[target];
  SphereEstimate estimate;
  estimate.seeingCameraCount = position ? static_cast<int>(position->bearings.size()) : 0;
  if (position) {
    tracked.secondsSinceSeen = 0.0;
  }
  if (position && setup_.usesKalmanFilter) {
    tracked.filter.update(position->position, position->covariance);
  }
  if (setup_.usesKalmanFilter && tracked.filter.isStarted()) {
    tracked.lastPosition = tracked.filter.position();
    estimate.covariance = tracked.filter.covariance();
    estimate.isValid = true;
  } else if (position && !setup_.usesKalmanFilter) {
    tracked.lastPosition = position->position;
    estimate.covariance = position->covariance;
    estimate.isValid = true;
  }
  estimate.mean = tracked.lastPosition.value_or(Eigen::Vector3d::Zero());
  estimate.best = estimate.mean;
  estimate.existenceProbability = estimate.isValid ? 1.0 : 0.0;
  estimate.particleCount = estimate.isValid ? 1 : 0;
  estimate.effectiveSampleSize = estimate.particleCount;
  estimates_[target] = estimate;
}

void BaselineTracker::copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                    Eigen::ArrayXd& weights) const {
  const bool shown = limit > 0 && estimates_.at(target).isValid;
  positions.resize(shown ? 1 : 0, 3);
  weights = Eigen::ArrayXd::Ones(positions.rows());
  if (shown) {
    positions.row(0) = estimates_[target].mean.transpose();
  }
}

} // namespace dewpoint::experiment
