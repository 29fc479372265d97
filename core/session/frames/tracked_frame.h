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
  /// The cameras do not confirm the target now. They never did before, or they last did less than
  /// kLostAfter seconds ago.
  Searching,
  Held, ///< the cameras confirm the estimate of the target
  /// The cameras confirm the target, or nearly do, but another object is about as likely to be the
  /// target.
  Ambiguous,
  /// The cameras confirmed the target earlier, but not in the last kLostAfter seconds.
  Lost,
  Gone, ///< the target was removed or not yet created, so there is nothing to search for
};
/// Time in seconds after which a target that is not held (confirmed by the cameras) counts as lost.
inline constexpr double kLostAfter = 1.0;

/// Estimate and state of one target in one frame.
struct TrackedTarget {
  TrackEstimate estimate;
  Eigen::ArrayXXf particles; ///< one row per particle: x, y, z in meters
  Eigen::ArrayXf weights;    ///< weights of the particles, linear
  std::vector<CandidatePosition> positionCandidates;
  std::vector<CameraReport>
      cameraReports; ///< per camera: whether it confirms the target, or why not
  TargetStatus status = TargetStatus::Searching;
  /// Particles in the image, if the target is a bounding box.
  BoxParticles boxParticles;
  /// Time, in seconds, at which the target was last held (confirmed by the cameras); the time of
  /// this frame if the target is held now.
  double lastHeldTime = -std::numeric_limits<double>::infinity();
};

/// Results of one tracked frame, without its images.
struct TrackedFrame {
  std::int64_t frame = 0;
  double time = 0.0;                    ///< time of the frame, seconds
  int iterationCount = 0;               ///< number of iterations on this frame
  std::int64_t totalIterationCount = 0; ///< number of iterations since the start or restart
  std::shared_ptr<const std::vector<Target>>
      targetDefinitions; ///< the targets as defined by the user
  std::vector<TrackedTarget>
      targets; ///< targets in this frame, in the order of `targetDefinitions`
  /// State of each camera, only for methods that track people; empty for other methods.
  std::vector<PeopleCameraState> peopleCameras;

  std::size_t memoryBytes() const;
};

/// Data about one tracked frame that the timeline shows.
struct FrameRecord {
  struct Entry {
    TargetStatus status = TargetStatus::Searching;
    float existenceProbability = 0.0F;
    /// What each camera reports about the target; empty while the target is held (confirmed by the
    /// cameras).
    std::vector<CameraReport> cameraReports;
  };
  std::int64_t frame = 0;
  double time = 0.0; ///< time of the frame, seconds
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
