// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_tracker.h"

#include "core/color/match_image.h"
#include "core/filter/assignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// Blobs per camera that are looked at beyond the number of targets.
constexpr std::size_t kSpareBlobs = 4;
/// Meters that a target seen nowhere yet is away from every place: it takes what others leave.
constexpr double kNeverSeen = 1e3;

/// Which place each member gets; places.size() for none.
std::vector<std::size_t> shareOut(const std::vector<std::optional<Eigen::Vector3d>>& last,
                                  const std::vector<TriangulatedPoint>& measured) {
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(last.size()),
                       static_cast<Eigen::Index>(measured.size()));
  for (std::size_t row = 0; row < last.size(); ++row) {
    for (std::size_t column = 0; column < measured.size(); ++column) {
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          last[row] ? (measured[column].position - *last[row]).norm() : kNeverSeen;
    }
  }
  std::vector<std::size_t> result;
  for (const Eigen::Index column : assignMinimumCost(cost).columnOfRow) {
    result.push_back(column == kUnassigned ? measured.size() : static_cast<std::size_t>(column));
  }
  return result;
}

} // namespace

std::vector<std::optional<Eigen::Vector2d>>
LargestBlobFinder::find(const std::vector<cv::Mat>& masks) {
  std::vector<std::optional<Eigen::Vector2d>> result;
  for (const cv::Mat& mask : masks) {
    const auto blobs = findBlobs(mask);
    result.push_back(blobs.empty() ? std::nullopt : std::optional(blobs.front().center));
  }
  return result;
}

BaselineTracker::BaselineTracker(const BaselineSetup& setup, const CameraRig& rig,
                                 std::vector<Target> targets)
    : setup_(setup), targets_(std::move(targets)) {
  BaselineTracker::setCameras(rig);
  restart(0);
}

void BaselineTracker::setCameras(const CameraRig& rig) {
  cameras_ = std::vector<Unprojector>(rig.begin(), rig.end());
  focalLengths_.clear();
  for (const Camera& camera : rig) {
    focalLengths_.push_back(std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY));
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
    tracked_.push_back({setup_.finder(), KalmanPoint(), std::nullopt});
  }
  estimates_.assign(targets_.size(), SphereEstimate{});
  time_.reset();
}

void BaselineTracker::iterate(ThreadTeam&) {
  if (!frames_) {
    return;
  }
  predict();
  Measured measured(targets_.size());
  std::vector<bool> done(targets_.size(), false);
  for (std::size_t first = 0; first < targets_.size(); ++first) {
    std::vector<std::size_t> members;
    for (std::size_t k = first; k < targets_.size(); ++k) {
      if (!done[k] && targets_[k].color == targets_[first].color) {
        members.push_back(k);
        done[k] = true;
      }
    }
    if (members.empty()) {
      continue;
    }
    const auto masks = masksOf(targets_[first].color);
    if (members.size() > 1 && setup_.manyBlobs) {
      findMany(members, masks, measured);
    } else {
      for (const std::size_t k : members) {
        measured[k] = findOne(tracked_[k], masks);
      }
    }
  }
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    conclude(k, measured[k]);
  }
}

void BaselineTracker::predict() {
  const double elapsed = time_ ? seconds(frames_->time - *time_) : 0.0;
  time_ = frames_->time;
  for (Tracked& tracked : tracked_) {
    if (setup_.kalman && elapsed > 0.0) {
      tracked.filter.predict(elapsed);
    }
    if (setup_.kalman && tracked.filter.started()) {
      tracked.last = tracked.filter.position();
    }
  }
}

std::vector<cv::Mat> BaselineTracker::masksOf(const ColorRange& color) const {
  const ColorClassifier classifier(color);
  std::vector<cv::Mat> masks(cameras_.size());
  for (std::size_t camera = 0; camera < std::min(cameras_.size(), frames_->frames.size());
       ++camera) {
    if (const FramePtr& frame = frames_->frames[camera]) {
      masks[camera] = matchImage(frame->image, classifier);
    }
  }
  return masks;
}

std::optional<Bearing> BaselineTracker::bearingOf(std::size_t camera, std::size_t blob,
                                                  const Eigen::Vector2d& pixel) const {
  const auto ray = cameras_[camera].ray(pixel);
  return ray ? std::optional(Bearing{camera, blob, *ray, focalLengths_[camera]}) : std::nullopt;
}

std::optional<TriangulatedPoint> BaselineTracker::findOne(Tracked& tracked,
                                                          const std::vector<cv::Mat>& masks) const {
  const auto pixels = tracked.finder->find(masks);
  std::vector<Bearing> bearings;
  for (std::size_t camera = 0; camera < pixels.size(); ++camera) {
    if (const auto bearing =
            pixels[camera] ? bearingOf(camera, 0, *pixels[camera]) : std::nullopt) {
      bearings.push_back(*bearing);
    }
  }
  return triangulate(std::move(bearings));
}

void BaselineTracker::findMany(const std::vector<std::size_t>& members,
                               const std::vector<cv::Mat>& masks, Measured& measured) const {
  std::vector<std::vector<Bearing>> bearings(masks.size());
  for (std::size_t camera = 0; camera < masks.size(); ++camera) {
    const auto blobs = findBlobs(masks[camera]);
    for (std::size_t k = 0; k < std::min(blobs.size(), members.size() + kSpareBlobs); ++k) {
      if (const auto bearing = bearingOf(camera, k, blobs[k].center)) {
        bearings[camera].push_back(*bearing);
      }
    }
  }
  const auto found = triangulateMany(bearings, members.size(), setup_.residualPx);
  std::vector<std::optional<Eigen::Vector3d>> last;
  last.reserve(members.size());
  for (const std::size_t k : members) {
    last.push_back(tracked_[k].last);
  }
  const auto shares = shareOut(last, found);
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (shares[k] < found.size()) {
      measured[members[k]] = found[shares[k]];
    }
  }
}

void BaselineTracker::conclude(std::size_t target,
                               const std::optional<TriangulatedPoint>& position) {
  Tracked& tracked = tracked_[target];
  SphereEstimate estimate;
  estimate.camerasSeeing = position ? static_cast<int>(position->bearings.size()) : 0;
  if (position && setup_.kalman) {
    tracked.filter.update(position->position, position->covariance);
  }
  if (setup_.kalman && tracked.filter.started()) {
    tracked.last = tracked.filter.position();
    estimate.covariance = tracked.filter.covariance();
    estimate.valid = true;
  } else if (position && !setup_.kalman) {
    tracked.last = position->position;
    estimate.covariance = position->covariance;
    estimate.valid = true;
  }
  estimate.mean = tracked.last.value_or(Eigen::Vector3d::Zero());
  estimate.best = estimate.mean;
  estimate.existenceProbability = estimate.valid ? 1.0 : 0.0;
  estimate.particleCount = estimate.valid ? 1 : 0;
  estimate.effectiveSampleSize = estimate.particleCount;
  estimates_[target] = estimate;
}

void BaselineTracker::particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                Eigen::ArrayXd& weights) const {
  const bool shown = limit > 0 && estimates_.at(target).valid;
  positions.resize(shown ? 1 : 0, 3);
  weights = Eigen::ArrayXd::Ones(positions.rows());
  if (shown) {
    positions.row(0) = estimates_[target].mean.transpose();
  }
}

} // namespace dewpoint::experiment
