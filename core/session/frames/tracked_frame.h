// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace dewpoint::session {

/// Status of a target, shown as one word.
enum class TargetStatus {
  Searching, ///< not held, and either never held before or held less than kLostAfter ago
  Held,      ///< the cameras confirm the estimate
  Ambiguous, ///< held, or nearly so, but another object is about as likely to be the target
  Lost,      ///< was held, but not in the last kLostAfter seconds
  Gone,      ///< removed, or not yet created: there is nothing to search for
};
/// Time in seconds after which a target that is not held counts as lost.
inline constexpr double kLostAfter = 1.0;

/// Estimate and state of one target in one frame.
struct TrackedTarget {
  TrackEstimate estimate;
  Eigen::ArrayXXf particles; ///< rows of x, y, z; meters
  Eigen::ArrayXf weights;    ///< one per row, linear
  std::vector<CandidatePosition> positionCandidates;
  std::vector<CameraReport> reasons; ///< per camera: whether it confirms the target, or why not
  TargetStatus status = TargetStatus::Searching;
  BoxParticles boxParticles; ///< particles of a BoxEstimate
  /// Time in seconds when the target was last held; the time of this frame if it is held now.
  double lastHeld = -std::numeric_limits<double>::infinity();
};

/// Results of one tracked frame, without its images.
struct TrackedFrame {
  std::int64_t frame = 0;
  double time = 0.0;                ///< seconds
  int iterations = 0;               ///< number of iterations on this frame
  std::int64_t totalIterations = 0; ///< number of iterations since the start or restart
  std::shared_ptr<const std::vector<Target>> definitions; ///< the targets as defined by the user
  std::vector<TrackedTarget> targets; ///< targets in this frame, in the order of `definitions`
  /// State of each camera; empty except for methods for people.
  std::vector<PeopleCameraState> peopleCameras;

  std::size_t bytes() const;
};

/// Record of one frame for the timeline.
struct FrameRecord {
  struct Entry {
    TargetStatus status = TargetStatus::Searching;
    float existenceProbability = 0.0F;
    std::vector<CameraReport> reasons; ///< empty while held
  };
  std::int64_t frame = 0;
  double time = 0.0;                ///< seconds
  std::uint64_t missingCameras = 0; ///< bit k: camera k delivered no image (the first 64 cameras)
  /// Problems of live cameras at the time of the frame; null if there were none. Consecutive frames
  /// share the list while it does not change.
  std::shared_ptr<const std::vector<Error>> cameraProblems = nullptr;
  std::vector<Entry> targets;
};

/// Returns the status of a target at `time`, given whether it is held at that time and when it was
/// last held. Times are in seconds.
TargetStatus statusOf(bool held, double time, double lastHeld);
/// Returns the record of a frame.
FrameRecord frameRecord(const TrackedFrame& trackedFrame, const FrameSet& frames);

} // namespace dewpoint::session
