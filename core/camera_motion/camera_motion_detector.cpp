// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/camera_motion_detector.h"

#include "core/base/angle.h"
#include "core/base/statistics.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::camera_motion {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kInterval = 0.2;              // seconds between two checks of one camera
constexpr std::size_t kChecks = 5;             // whose median counts
constexpr double kMovedAngle = 0.05 * kDegree; // half of what must be reported
constexpr double kBack = 0.03 * kDegree;       // below it the camera stands as before
constexpr double kSignificant = 6.0;           // standard errors
/// Patches that must agree on a rotation.
constexpr int kFewestPatches = 6;
constexpr int kGridColumns = 8; // at most one patch in each part of the image
constexpr int kGridRows = 6;
constexpr int kParts = kGridColumns * kGridRows;
constexpr int kPartsAtOnce = 4;       // so that no check takes long
constexpr double kAlike = 0.7;        // normalized correlation
constexpr double kForgetAfter = 30.0; // seconds without being seen
constexpr double kLearnEvery = 2.0;   // seconds, while patches are missing
constexpr int kThumbnail = 4;         // pixels of the image in one of the thumbnail
/// Response of phase correlation, at least.
constexpr double kThumbnailResponse = 0.15;

/// Of each component of rotation vectors.
Eigen::Vector3d medianRotation(const std::deque<Eigen::Vector3d>& turns) {
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(turns.size());
    for (const Eigen::Vector3d& turn : turns) {
      values.push_back(turn[axis]);
    }
    result[axis] = upperMedian(std::move(values));
  }
  return result;
}

cv::Mat thumbnailOf(const cv::Mat& image) {
  cv::Mat small, gray, result;
  cv::resize(image, small, {image.cols / kThumbnail, image.rows / kThumbnail}, 0, 0,
             cv::INTER_AREA);
  cv::cvtColor(small, gray, cv::COLOR_BGR2GRAY);
  gray.convertTo(result, CV_32F);
  return result;
}

/// The patch of most structure in one part of the image, among a few places.
std::optional<BackgroundPatch> bestPatch(const cv::Mat& image, const cv::Rect& part) {
  /// Along each side of a part, at which patches are tried.
  constexpr int kSamples = 5;
  std::optional<BackgroundPatch> best;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const cv::Point cell(part.x + (2 * (i % kSamples) + 1) * part.width / (2 * kSamples),
                         part.y + (2 * (i / kSamples) + 1) * part.height / (2 * kSamples));
    auto patch = BackgroundPatch::at(image, cell);
    if (patch && (!best || patch->minEigenvalue() > best->minEigenvalue())) {
      best = std::move(patch);
    }
  }
  return best;
}

} // namespace

CameraMotionDetector::CameraMotionDetector(const CameraRig& rig) {
  for (const Camera& camera : rig) {
    watched_.emplace_back().camera = camera;
  }
}

void CameraMotionDetector::restart() {
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    acceptMovedCamera(k, Camera(watched_[k].camera));
  }
  events_.clear();
  lastTime_ = -1e18;
}

void CameraMotionDetector::acceptMovedCamera(std::size_t camera, const Camera& now) {
  WatchedCamera anew;
  anew.camera = now;
  watched_[camera] = std::move(anew);
}

void CameraMotionDetector::watch(const FrameSet& frames) {
  const double time = seconds(frames.time);
  if (time <= lastTime_) {
    return;
  }
  lastTime_ = time;
  for (std::size_t k = 0; k < watched_.size() && k < frames.frames.size(); ++k) {
    const FramePtr& frame = frames.frames[k];
    const Intrinsics& in = watched_[k].camera.intrinsics;
    if (!frame || frame->image.type() != CV_8UC3 || time < watched_[k].nextCheckTime ||
        frame->image.size() != cv::Size(in.width, in.height)) {
      continue;
    }
    // The first time at once; then one camera after the other, so that no frame pays for all.
    const bool first = watched_[k].patches.empty();
    const double stagger = first ? kInterval * double(k) / double(watched_.size()) : 0.0;
    watched_[k].nextCheckTime = time + kInterval + stagger;
    check(k, *frame, frames);
  }
}

void CameraMotionDetector::learn(WatchedCamera& watched, const cv::Mat& image, double time,
                                 const Eigen::Vector3d& turn, int parts) {
  watched.lastPatchSearchTime = time;
  const int width = image.cols / kGridColumns;
  const int height = image.rows / kGridRows;
  for (int tried = 0; tried < kParts && parts > 0; ++tried) {
    const int part = std::exchange(watched.nextImagePart, (watched.nextImagePart + 1) % kParts);
    const cv::Rect cell(part % kGridColumns * width, part / kGridColumns * height, width, height);
    if (std::ranges::any_of(watched.patches, [&](const TrackedPatch& tracked) {
          return cell.contains(tracked.patch.center());
        })) {
      continue;
    }
    --parts;
    auto patch = bestPatch(image, cell);
    const auto shiftJacobian =
        patch ? rotationJacobian(watched.camera,
                                 Eigen::Vector2d(patch->center().x, patch->center().y))
              : std::nullopt;
    if (shiftJacobian) {
      watched.patches.push_back({std::move(*patch), *shiftJacobian, turn, time});
    }
  }
}

std::optional<CameraRotation> CameraMotionDetector::measure(WatchedCamera& watched,
                                                            const cv::Mat& image, double time,
                                                            const Eigen::Vector3d& guess) {
  std::vector<BackgroundShift> shifts;
  std::vector<TrackedPatch*> found;
  for (TrackedPatch& tracked : watched.patches) {
    const auto match =
        tracked.patch.find(image, tracked.shiftJacobian * (guess - tracked.initialRotation));
    if (match && match->correlation > kAlike) {
      shifts.push_back({match->shift + tracked.shiftJacobian * tracked.initialRotation,
                        tracked.shiftJacobian, tracked.patch.shiftCovariance()});
      found.push_back(&tracked);
    }
  }
  const auto turn = fitRotation(shifts);
  // Fewer than half of what is known: rather something that covers and moves with its own pattern.
  if (!turn || turn->usedShiftCount < kFewestPatches ||
      2 * std::size_t(turn->usedShiftCount) < shifts.size() ||
      3 * std::size_t(turn->usedShiftCount) < watched.patches.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if ((shifts[i].shift - shifts[i].shiftJacobian * turn->turn).norm() < 1.0) {
      found[i]->lastSeenTime = time;
    }
  }
  return turn;
}

std::optional<Eigen::Vector3d>
CameraMotionDetector::estimateLargeRotation(const WatchedCamera& watched, const cv::Mat& image) {
  if (watched.thumbnail.empty() || image.cols / kThumbnail != watched.thumbnail.cols ||
      image.rows / kThumbnail != watched.thumbnail.rows) {
    return std::nullopt;
  }
  double response = 0.0;
  cv::Mat window;
  cv::createHanningWindow(window, watched.thumbnail.size(), CV_32F);
  const cv::Point2d shift =
      cv::phaseCorrelate(watched.thumbnail, thumbnailOf(image), window, &response);
  if (response < kThumbnailResponse) {
    return std::nullopt;
  }
  const auto shiftJacobian = rotationJacobian(watched.camera, {image.cols / 2.0, image.rows / 2.0});
  if (!shiftJacobian) {
    return std::nullopt;
  }
  const Eigen::Vector2d pixels(kThumbnail * shift.x, kThumbnail * shift.y);
  const Eigen::Vector2d turn = shiftJacobian->leftCols<2>().inverse() * pixels;
  return Eigen::Vector3d(turn.x(), turn.y(), 0.0);
}

void CameraMotionDetector::check(std::size_t camera, const Frame& frame, const FrameSet& frames) {
  WatchedCamera& watched = watched_[camera];
  const double time = seconds(frames.time);
  if (watched.thumbnail.empty()) {
    watched.thumbnail = thumbnailOf(frame.image);
    learn(watched, frame.image, time, Eigen::Vector3d::Zero(), kParts);
    return;
  }
  const Eigen::Vector3d guess =
      watched.rotations.empty() ? Eigen::Vector3d::Zero() : watched.rotations.back();
  auto turn = measure(watched, frame.image, time, guess);
  if (!turn && watched.patches.size() >= std::size_t(kFewestPatches)) {
    if (const auto large = estimateLargeRotation(watched, frame.image)) {
      turn = measure(watched, frame.image, time, *large);
      // Something large that moves has a shift of its own: most of the patches must agree.
      if (turn && 2 * std::size_t(turn->usedShiftCount) < watched.patches.size()) {
        turn.reset();
      }
    }
  }
  watched.state.isAssessed = turn.has_value();
  if (turn) {
    assess(camera, *turn, frames);
  }
  if (turn && time - watched.lastPatchSearchTime > kLearnEvery) {
    std::erase_if(watched.patches, [&](const TrackedPatch& tracked) {
      return time - tracked.lastSeenTime > kForgetAfter;
    });
    learn(watched, frame.image, time, watched.state.rotation.turn, kPartsAtOnce);
  }
}

void CameraMotionDetector::assess(std::size_t camera, const CameraRotation& turn,
                                  const FrameSet& frames) {
  WatchedCamera& watched = watched_[camera];
  watched.rotations.push_back(turn.turn);
  if (watched.rotations.size() > kChecks) {
    watched.rotations.pop_front();
  }
  CameraMotionState& state = watched.state;
  state.rotation = turn;
  state.rotation.turn = medianRotation(watched.rotations);
  if (watched.rotations.size() < kChecks) {
    return;
  }
  const double angle = state.rotation.turn.norm();
  if (!state.hasMoved && angle > kMovedAngle && turn.significance > kSignificant) {
    state.hasMoved = true;
    events_.push_back({camera, frames.index, frames.time, state.rotation});
  } else if (state.hasMoved && angle < kBack) {
    state.hasMoved = false;
  }
}

} // namespace dewpoint::camera_motion
