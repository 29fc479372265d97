// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  Searching, ///< not held, or not yet held
  Held,      ///< the cameras confirm the estimate
  Ambiguous, ///< held, or nearly so, but another object may be the target about as well
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
  std::vector<CandidatePosition> proposals;
  std::vector<CameraReport> reasons; ///< per camera, why the camera does not confirm the target
  TargetStatus status = TargetStatus::Searching;
  BoxParticles boxParticles; ///< of a BoxEstimate
  /// Time when last held, seconds; time of this frame if held now.
  double lastHeld = -std::numeric_limits<double>::infinity();
};

/// Results of one tracked frame, without its images.
struct TrackedFrame {
  std::int64_t frame = 0;
  double time = 0.0;                                      ///< seconds
  int iterations = 0;                                     ///< on this frame
  std::int64_t totalIterations = 0;                       ///< since the (re)start
  std::shared_ptr<const std::vector<Target>> definitions; ///< the targets as defined by the user
  std::vector<TrackedTarget> targets;                     ///< in the same order
  /// Per camera; empty except with methods for people.
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
  std::vector<Entry> targets;
};

/// Returns the status of a target that is held or not held at `time`, given when it was last held;
/// seconds.
TargetStatus statusOf(bool held, double time, double lastHeld);
/// Returns the record of a frame.
FrameRecord frameRecord(const TrackedFrame& trackedFrame, const FrameSet& frames);

} // namespace dewpoint::session
