// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/run/tracking_run.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace dewpoint::session {

/// Memory limits, in bytes, for the parts of a run's history (the data needed to go back to past
/// frames).
struct HistoryLimits {
  std::size_t imageBytes = 0;        ///< memory for images
  std::size_t trackedFrameBytes = 0; ///< memory for particles and estimates
  /// Memory for checkpoints: copies of the tracker, from which tracking can continue.
  std::size_t checkpointBytes = 0;
  /// Returns memory limits that sum to `total` bytes. With live cameras, most of the memory is for
  /// images.
  static HistoryLimits forTotal(std::size_t total, bool live);
  std::size_t totalBytes() const { return imageBytes + trackedFrameBytes + checkpointBytes; }
};

/// Returns the point that an estimate adds to the tail of its target (the drawn recent path): the
/// mean position in meters, or NaN if the target is not held (confirmed by the cameras).
Eigen::Vector3d tailPosition(const TrackEstimate& estimate);

/// Results of every frame tracked so far, and checkpoints: saved states of the run, from which each
/// frame can be reached again by tracking. When the memory limit is reached, every second frame of
/// the older half loses its particles (never its estimate), and every second checkpoint is removed.
/// Used by one thread.
class History {
public:
  explicit History(const HistoryLimits& limits) : limits_(limits) {}

  /// Removes all results and checkpoints (saved states), for a new run.
  void clear();
  /// Stores a checkpoint (the state of the run) if the last one is far enough back. Must be called
  /// before the run begins `frame`.
  void noteFrameBegin(std::int64_t frame, const TrackingRun& run);
  /// Stores a change that was made to the run in `frame`, after `iterations` iterations on this
  /// frame.
  void recordChange(std::int64_t frame, int iterations, const RunChange& change);
  /// Stores the results of a frame that was tracked, or tracked again.
  void record(TrackedFrame trackedFrame);
  /// Removes the results, checkpoints and changes of frame `frame` and of later frames. A
  /// checkpoint from right before this frame is kept.
  void forgetFrom(std::int64_t frame);
  /// Removes all checkpoints (saved states of the run). Call this when the method has changed.
  void removeCheckpoints();
  /// Makes all tails (drawn recent paths) begin at this frame, so that they do not continue earlier
  /// estimates.
  void startTailsAt(std::int64_t frame) { tailBegins_.insert(frame); }
  /// Removes all data of frames before this one, whose images no longer exist.
  void forgetBefore(std::int64_t frame);

  /// Returns the results of a frame; null if it was not tracked.
  const TrackedFrame* at(std::int64_t frame) const;
  /// Returns the results of the last tracked frame before this one; null if there is none.
  const TrackedFrame* before(std::int64_t frame) const;
  const TrackedFrame* newest() const {
    return trackedFrames_.empty() ? nullptr : &trackedFrames_.back();
  }
  /// Returns the results of the first tracked frame after this one; null if there is none.
  const TrackedFrame* after(std::int64_t frame) const;
  /// Largest number of positions in a tail (drawn recent path) of a target.
  static constexpr std::size_t kTailLength = 256;
  /// Returns the tail (recent path) of a target up to and including frame `end`: the last
  /// kTailLength values of tailPosition(), oldest first. `frame` is the frame shown: `end` itself,
  /// or the frame after it if the results of that frame are not recorded yet. startTailsAt() may
  /// have set frames at which all tails begin; no position before the latest such frame up to
  /// `frame` is included. The tail is empty for targets that are boxes and for targets that are
  /// gone.
  std::vector<Eigen::Vector3d> tail(std::size_t target, std::int64_t frame, std::int64_t end) const;

  /// Saved state of the run, from which a later frame can be reached by tracking.
  struct Checkpoint {
    std::int64_t frame = 0; ///< frame that the run begins next from this state
    TrackingRun::State state;
  };
  /// Returns the last checkpoint (saved state of the run) at or before this frame; null if there is
  /// none.
  const Checkpoint* checkpointFor(std::int64_t frame) const;
  /// Returns the frame at which the method began from scratch, and the run's definition at that
  /// time. The returned state contains no tracker. Empty before the first frame.
  const std::optional<Checkpoint>& methodStart() const { return methodStart_; }
  /// Returns the changes that were made to the run in `frame` after `iterations` iterations on this
  /// frame, in order.
  std::vector<RunChange> changesAt(std::int64_t frame, int iterations) const;

  const HistoryLimits& limits() const { return limits_; }
  std::size_t memoryBytes() const { return trackedFrameBytes_ + checkpointBytes_; }

private:
  void thinTrackedFrames();
  void forgetParticles(TrackedFrame& trackedFrame);
  void thinCheckpoints();
  std::deque<TrackedFrame>::const_iterator lowerBound(std::int64_t frame) const;

  HistoryLimits limits_;
  std::deque<TrackedFrame> trackedFrames_; ///< ascending frames
  std::size_t trackedFrameBytes_ = 0;
  std::map<std::int64_t, Checkpoint> checkpoints_;
  std::size_t checkpointBytes_ = 0;
  std::int64_t spacing_ = 0; ///< frames between checkpoints
  std::optional<Checkpoint> methodStart_;
  std::map<std::pair<std::int64_t, int>, std::vector<RunChange>> changes_;
  std::set<std::int64_t> tailBegins_;
};

} // namespace dewpoint::session
