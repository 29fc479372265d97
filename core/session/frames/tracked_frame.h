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

/// How a target is doing, in the one word that is shown of it.
enum class TargetStatus {
  Searching, ///< not held, or not held yet
  Held,      ///< the cameras confirm the estimate
  Ambiguous, ///< the same, or nearly so, but something else may be the target about as well
  Lost,      ///< was held, and has not been for kLostAfter seconds
  Gone,      ///< removed, or not created yet: there is nothing to search for
};
/// Seconds after which a target that is not held counts as lost.
inline constexpr double kLostAfter = 1.0;

/// One target as it was believed at one frame.
struct TrackedTarget {
  TrackEstimate estimate;
  Eigen::ArrayXXf particles; ///< rows x y z, meters
  Eigen::ArrayXf weights;    ///< one per row, linear
  std::vector<CandidatePosition> proposals;
  std::vector<CameraReport> reasons; ///< per camera, why it does not confirm the target
  TargetStatus status = TargetStatus::Searching;
  BoxParticles boxParticles;                                  ///< of a BoxEstimate
  double lastHeld = -std::numeric_limits<double>::infinity(); ///< seconds; this frame's if held now
};

/// What is kept of one tracked frame, apart from its images.
struct TrackedFrame {
  std::int64_t frame = 0;
  double time = 0.0;                                      ///< seconds
  int iterations = 0;                                     ///< on this frame
  std::int64_t totalIterations = 0;                       ///< since the (re)start
  std::shared_ptr<const std::vector<Target>> definitions; ///< the targets as they were defined
  std::vector<TrackedTarget> targets;                     ///< in the same order
  std::vector<PeopleCameraState> peopleCameras; ///< per camera; empty but for methods for people

  std::size_t bytes() const;
};

/// One frame in the record that a timeline is drawn from.
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

/// Status of a target that is (not) held at `time`, given when it was held last.
TargetStatus statusOf(bool held, double time, double lastHeld);
/// The record of a frame.
FrameRecord frameRecord(const TrackedFrame& trackedFrame, const FrameSet& frames);

} // namespace dewpoint::session
