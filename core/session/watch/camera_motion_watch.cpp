// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_motion_watch.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::session {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kBoardRemovalSeconds =
    3.0; // seconds from the end of a calibration until its board is gone
constexpr double kUpdateInterval = 1.0; // seconds
constexpr double kSettled = 1.0;        // seconds after a motion that count for nothing
constexpr double kWindow = 2.0;         // seconds of residuals that are compared
/// Residuals that are compared.
constexpr std::size_t kFewest = 10;
constexpr std::int64_t kSameMotion = 60; // frames: where a run that begins again may notice it
constexpr double kSightingSigma = 1.0;   // pixels: blob, and the other cameras' calibration

} // namespace

Result<MovedCameraPose> estimatePoseAfterMotion(const Camera& camera, const CameraRotation& turn,
                                                const std::deque<ReprojectionResidual>& sightings,
                                                double since) {
  std::vector<PointSighting> points;
  for (const ReprojectionResidual& one : sightings) {
    if (one.captureTime >= since) {
      points.push_back({one.world, one.pixel, kSightingSigma});
    }
  }
  CameraMotionPrior prior;
  prior.turn = turn.turn;
  prior.rotationSigma = std::max(prior.rotationSigma, turn.sigma);
  return estimateMovedPose(camera, prior, points);
}

CameraMotionWatch::CameraMotionWatch(const CameraRig& rig)
    : rig_(rig), detector_(rig), sightings_(rig), solvedAt_(rig.size()) {}

bool CameraMotionWatch::isSolved(const CameraMotionEvent& event) const {
  const auto& at = solvedAt_[event.camera];
  return at && std::abs(event.frame - *at) <= kSameMotion;
}

void CameraMotionWatch::restart() {
  detector_.restart();
  sightings_.restart();
  reports_.clear();
  eventsSeen_ = 0;
  due_ = 0.0;
  lastTime_ = -1e18;
  resumeTime_ = -1e18;
}

void CameraMotionWatch::setCameras(const CameraRig& rig) {
  for (std::size_t k = 0; k < std::min(rig.size(), rig_.size()); ++k) {
    if (rig[k] != rig_[k]) {
      const auto moved = std::ranges::find_if(
          reports_, [&](const CameraMotionReport& one) { return one.event.camera == k; });
      solvedAt_[k] = moved != reports_.end() ? std::optional(moved->event.frame) : std::nullopt;
      detector_.acceptMovedCamera(k, rig[k]);
      std::erase_if(reports_,
                    [&](const CameraMotionReport& report) { return report.event.camera == k; });
    }
  }
  rig_ = rig;
  sightings_ = ReprojectionResiduals(rig);
}

void CameraMotionWatch::setPaused(bool paused) {
  if (paused_ && !paused) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      if (std::ranges::none_of(
              reports_, [&](const CameraMotionReport& one) { return one.event.camera == k; })) {
        detector_.acceptMovedCamera(k, rig_[k]);
      }
    }
  }
  resumed_ = resumed_ || (paused_ && !paused);
  paused_ = paused;
}

void CameraMotionWatch::watch(const FrameSet& frames, const std::vector<Target>& targets,
                              const std::vector<SphereEstimate>& estimates) {
  const double time = seconds(frames.time);
  if (time <= lastTime_ || paused_) {
    return; // a frame of the past that is tracked again
  }
  if (resumed_) {
    resumed_ = false;
    resumeTime_ = time + kBoardRemovalSeconds;
  }
  if (time < resumeTime_) {
    return;
  }
  lastTime_ = time;
  detector_.watch(frames);
  sightings_.add(frames, targets, estimates);
  for (; eventsSeen_ < detector_.events().size(); ++eventsSeen_) {
    const auto event = detector_.events()[eventsSeen_];
    if (isSolved(event)) {
      detector_.acceptMovedCamera(event.camera, rig_[event.camera]);
    } else {
      reports_.emplace_back().event = event;
    }
  }
  if (time < due_) {
    return;
  }
  due_ = time + kUpdateInterval;
  for (CameraMotionReport& report : reports_) {
    update(report, time);
  }
}

void CameraMotionWatch::update(CameraMotionReport& report, double time) {
  const std::size_t camera = report.event.camera;
  const double since = seconds(report.event.time) + kSettled;
  report.isBackInPose = !detector_.camera(camera).hasMoved;
  if (const auto now = sightings_.summarize(camera, time - kWindow, kFewest)) {
    report.targetDistancePx = now->residual.norm();
  }
  const CameraRotation& turn = detector_.camera(camera).rotation;
  // With two cameras the estimate leans on the moved one too: the background alone is better.
  const auto& sightings =
      rig_.size() < 3 ? std::deque<ReprojectionResidual>() : sightings_.residuals(camera);
  const auto solved = estimatePoseAfterMotion(rig_[camera], turn, sightings, since);
  report.newPose = solved && !report.isBackInPose ? std::optional(*solved) : std::nullopt;
}

std::vector<Error> CameraMotionWatch::notices() const {
  std::vector<Error> notices;
  for (const CameraMotionReport& report : reports_) {
    const double degrees = inDegrees(report.event.rotation.turn.norm());
    notices.push_back(
        {ErrorCode::Mismatch, "", rig_[report.event.camera].name,
         fmt::format("the camera was rotated by {:.2f} degrees in frame {}; calibrate it again",
                     degrees, report.event.frame)});
  }
  return notices;
}

} // namespace dewpoint::session
