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
  Searching, ///< not held, and either never held before or last held less than kLostAfter ago
  Held,      ///< the cameras confirm the estimate
  Ambiguous, ///< held or nearly held, but another object is about as likely to be the target
  Lost,      ///< was held, but not in the last kLostAfter seconds
  Gone,      ///< removed or not yet created, so there is nothing to search for
};
/// Time in seconds after which a target that is not held (confirmed by the cameras) counts as lost.
inline constexpr double kLostAfter = 1.0;

/// Estimate and state of one target in one frame.
struct TrackedTarget {
  TrackEstimate estimate;
  Eigen::ArrayXXf particles; ///< rows of x, y, z; meters
  Eigen::ArrayXf weights;    ///< one per row, linear
  std::vector<CandidatePosition> positionCandidates;
  std::vector<CameraReport>
      cameraReports; ///< per camera: whether it confirms the target, or why not
  TargetStatus status = TargetStatus::Searching;
  BoxParticles boxParticles; ///< particles of a BoxEstimate
  /// Time, in seconds, at which the target was last held (confirmed by the cameras); the time of
  /// this frame if the target is held now.
  double lastHeldTime = -std::numeric_limits<double>::infinity();
};

/// Results of one tracked frame, without its images.
struct TrackedFrame {
  std::int64_t frame = 0;
  double time = 0.0;                ///< seconds
  int iterations = 0;               ///< number of iterations on this frame
  std::int64_t totalIterations = 0; ///< number of iterations since the start or restart
  std::shared_ptr<const std::vector<Target>>
      targetDefinitions; ///< the targets as defined by the user
  std::vector<TrackedTarget>
      targets; ///< targets in this frame, in the order of `targetDefinitions`
  /// State of each camera, only for methods that track people; empty for other methods.
  std::vector<PeopleCameraState> peopleCameras;

  std::size_t bytes() const;
};

/// Data about one tracked frame that the timeline shows.
struct FrameRecord {
  struct Entry {
    TargetStatus status = TargetStatus::Searching;
    float existenceProbability = 0.0F;
    std::vector<CameraReport> cameraReports; ///< empty while held
  };
  std::int64_t frame = 0;
  double time = 0.0; ///< seconds
  std::uint64_t missingCameraBits =
      0; ///< bit k: camera k delivered no image (the first 64 cameras)
  /// Problems of live cameras at the time of the frame; null if there were none. Consecutive frames
  /// with the same problems share one list.
  std::shared_ptr<const std::vector<Error>> cameraProblems = nullptr;
  std::vector<Entry> targets;
};

/// Returns the status of a target at `time`: `held` tells whether the cameras confirm the target at
/// this time, `lastHeldTime` when they last did. Times are in seconds.
TargetStatus statusOf(bool held, double time, double lastHeldTime);
/// Returns the data that the timeline shows about a tracked frame.
FrameRecord frameRecord(const TrackedFrame& trackedFrame, const FrameSet& frames);

} // namespace dewpoint::session
