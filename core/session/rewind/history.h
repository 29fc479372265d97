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

/// Bytes that the parts of a run's history may take.
struct HistoryLimits {
  std::size_t frames = 0;        ///< images
  std::size_t trackedFrames = 0; ///< particles and estimates
  std::size_t checkpoints = 0;   ///< copies of the method to go on from
  /// A share of `total` for each; live cameras need most of it for images.
  static HistoryLimits of(std::size_t total, bool live);
  std::size_t sum() const { return frames + trackedFrames + checkpoints; }
};

/// What a tail shows of an estimate: its mean, or nothing finite where it was only guessed.
Eigen::Vector3d tailPosition(const TrackEstimate& estimate);

/// What was believed at every frame tracked so far, and copies of the method from which any of them
/// can be reached again. When the memory is used up, every second frame of the older half gives up
/// its particles (never its estimate), and every second copy is given up. Used by one thread.
class History {
public:
  explicit History(const HistoryLimits& limits) : limits_(limits) {}

  /// A new run: nothing of the old one holds.
  void clear();
  /// Before the run begins `frame`: keeps a copy of it from time to time.
  void beforeFrame(std::int64_t frame, const TrackingRun& run);
  /// A change was made while the run was at `frame`, after `iterations`.
  void changed(std::int64_t frame, int iterations, const RunChange& change);
  /// The frame was tracked, or tracked again.
  void record(TrackedFrame trackedFrame);
  /// Forgets results, copies and changes of this frame and of later ones; a copy made right before
  /// it stays.
  void forgetFrom(std::int64_t frame);
  /// Forgets all copies: they are of another method.
  void forgetCopies();
  /// Starts new tails at this frame: estimates from here on do not continue those before.
  void beginTails(std::int64_t frame) { tailBegins_.insert(frame); }
  /// Forgets what came before this frame (its images are gone).
  void forgetBefore(std::int64_t frame);

  /// Null when the frame was not tracked.
  const TrackedFrame* at(std::int64_t frame) const;
  /// The last one before this frame; null when there is none.
  const TrackedFrame* before(std::int64_t frame) const;
  const TrackedFrame* newest() const {
    return trackedFrames_.empty() ? nullptr : &trackedFrames_.back();
  }
  /// The first one after this frame; null when there is none.
  const TrackedFrame* after(std::int64_t frame) const;
  /// The most positions in a tail.
  static constexpr std::size_t kTailLength = 256;
  /// The tailPosition() of a target up to and with the frame `end`, of the tail that `frame`
  /// (`end`, or the next one, which is not recorded yet) belongs to: the last kTailLength of them,
  /// oldest first; nothing of targets that are boxes, or gone.
  std::vector<Eigen::Vector3d> tail(std::size_t target, std::int64_t frame, std::int64_t end) const;

  /// A state of the run from which a frame can be reached by tracking on.
  struct Checkpoint {
    std::int64_t frame = 0; ///< the next one to begin
    TrackingRun::State state;
  };
  /// The last one at or before this frame; null when there is none.
  const Checkpoint* checkpointFor(std::int64_t frame) const;
  /// Where the method began, knowing nothing, and with what; its state has no tracker. Nothing
  /// before that.
  const std::optional<Checkpoint>& begun() const { return begun_; }
  /// Changes made while the run was at `frame` after `iterations`, in order.
  std::vector<RunChange> changesAt(std::int64_t frame, int iterations) const;

  const HistoryLimits& limits() const { return limits_; }
  std::size_t bytes() const { return trackedFrameBytes_ + checkpointBytes_; }

private:
  void thinTrackedFrames();
  void forgetParticles(TrackedFrame& trackedFrame);
  void thinCheckpoints();
  std::deque<TrackedFrame>::const_iterator lowerBound(std::int64_t frame) const;

  HistoryLimits limits_;
  std::deque<TrackedFrame> trackedFrames_; ///< by rising frame
  std::size_t trackedFrameBytes_ = 0;
  std::map<std::int64_t, Checkpoint> checkpoints_;
  std::size_t checkpointBytes_ = 0;
  std::int64_t spacing_ = 0; ///< frames between checkpoints
  std::optional<Checkpoint> begun_;
  std::map<std::pair<std::int64_t, int>, std::vector<RunChange>> changes_;
  std::set<std::int64_t> tailBegins_;
};

} // namespace dewpoint::session
