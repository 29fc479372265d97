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

/// Memory limits of the parts of a run's history, in bytes.
struct HistoryLimits {
  std::size_t frames = 0;        ///< images
  std::size_t trackedFrames = 0; ///< particles and estimates
  std::size_t checkpoints = 0;   ///< copies of the tracker, from which tracking can continue
  /// Divides `total` among the parts; live cameras use most of it for images.
  static HistoryLimits of(std::size_t total, bool live);
  std::size_t sum() const { return frames + trackedFrames + checkpoints; }
};

/// Returns the point that an estimate adds to the tail of its target (the drawn recent path): the
/// mean, or NaN if the target is not held.
Eigen::Vector3d tailPosition(const TrackEstimate& estimate);

/// Results of every frame tracked so far, and checkpoints (copies of the method) from which each
/// frame can be reached again. When the memory limit is reached, every second frame of the older
/// half loses its particles (never its estimate), and every second checkpoint is removed. Used by
/// one thread.
class History {
public:
  explicit History(const HistoryLimits& limits) : limits_(limits) {}

  /// Removes everything, for a new run.
  void clear();
  /// Stores a checkpoint from time to time. Called before the run begins `frame`.
  void beforeFrame(std::int64_t frame, const TrackingRun& run);
  /// Stores a change made to the run in `frame`, after `iterations` iterations on this frame.
  void changed(std::int64_t frame, int iterations, const RunChange& change);
  /// Stores the results of a frame that was tracked, or tracked again.
  void record(TrackedFrame trackedFrame);
  /// Removes the results, checkpoints and changes of this frame and later ones. A checkpoint right
  /// before this frame is kept.
  void forgetFrom(std::int64_t frame);
  /// Removes all checkpoints because the method has changed.
  void removeCheckpoints();
  /// Makes tails begin at this frame, so that they do not continue earlier estimates.
  void beginTails(std::int64_t frame) { tailBegins_.insert(frame); }
  /// Removes everything before this frame, because the images of earlier frames no longer exist.
  void forgetBefore(std::int64_t frame);

  /// Returns a frame; null if it was not tracked.
  const TrackedFrame* at(std::int64_t frame) const;
  /// Returns the last tracked frame before this one; null if there is none.
  const TrackedFrame* before(std::int64_t frame) const;
  const TrackedFrame* newest() const {
    return trackedFrames_.empty() ? nullptr : &trackedFrames_.back();
  }
  /// Returns the first tracked frame after this one; null if there is none.
  const TrackedFrame* after(std::int64_t frame) const;
  /// Largest number of positions in a tail.
  static constexpr std::size_t kTailLength = 256;
  /// Returns the tail of a target up to and including frame `end`: the last kTailLength values of
  /// tailPosition(), oldest first. `frame` is `end` itself, or the next frame while its results are
  /// not recorded yet. The tail begins no earlier than the last beginTails() at or before `frame`.
  /// Empty for boxes and for targets that are gone.
  std::vector<Eigen::Vector3d> tail(std::size_t target, std::int64_t frame, std::int64_t end) const;

  /// State of the run from which a later frame can be reached by tracking.
  struct Checkpoint {
    std::int64_t frame = 0; ///< next frame to begin
    TrackingRun::State state;
  };
  /// Returns the last checkpoint at or before this frame; null if there is none.
  const Checkpoint* checkpointFor(std::int64_t frame) const;
  /// Returns the frame at which the method began from scratch, and the definition with which it
  /// began. The state in this checkpoint has no tracker. Empty before the first frame.
  const std::optional<Checkpoint>& methodStart() const { return methodStart_; }
  /// Returns the changes made in `frame` after `iterations` iterations on this frame, in order.
  std::vector<RunChange> changesAt(std::int64_t frame, int iterations) const;

  const HistoryLimits& limits() const { return limits_; }
  std::size_t bytes() const { return trackedFrameBytes_ + checkpointBytes_; }

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
