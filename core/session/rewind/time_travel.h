// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/frame_cache.h"
#include "core/session/rewind/history.h"
#include "core/session/run/snapshot.h"

#include <functional>
#include <memory>
#include <optional>

namespace dewpoint::session {

/// Goes back in a run: shows earlier frames as they were, and brings the run back to before a
/// frame, from where it tracks on with the same bits. Used by the tracking thread only.
class TimeTravel {
public:
  /// `source` is moved about to read recorded frames again. `bytes` limits all that is kept.
  TimeTravel(FrameSetSource& source, std::size_t bytes);

  /// A new run, at its beginning.
  void clear();
  /// The run is about to begin this frame set.
  void beforeFrame(const FrameSetPtr& frames, const TrackingRun& run);
  void changed(const TrackingRun& run, const RunChange& change);
  /// The run has finished (another iteration on) its frame.
  const TrackedFrame& record(const TrackingRun& run);

  /// Images of this frame; null when there are none (any more).
  Result<FrameSetPtr> frames(std::int64_t frame) { return cache_->at(frame); }
  /// The frame that can be shown and is nearest to this one; nothing before the first.
  std::optional<std::int64_t> nearest(std::int64_t frame) const;
  /// The next frame after this one that can be shown; nothing at the end.
  std::optional<std::int64_t> following(std::int64_t frame) const;
  /// As frames(), perhaps as a `preview`: small images, scaled up.
  Result<FrameSetPtr> previewAt(std::int64_t frame, bool& preview);
  /// Range and memory of what can be shown.
  HistoryState state() const;
  const History& history() const { return history_; }

  /// Whether to go on with something long.
  using GoOn = std::function<bool()>;
  /// Makes `run` what it was right before it began `frame`: from the nearest copy, tracking on. The
  /// frame it reached (`frame`, unless `goOn` said no) or an error. Nothing is forgotten yet; the
  /// run goes by what it went by then. When there is no copy before the frame, `run` begins again
  /// there.
  Result<std::int64_t> goBack(TrackingRun& run, std::int64_t frame, const GoOn& goOn);
  /// Forgets what was recorded of this frame and of later ones.
  void forgetFrom(std::int64_t frame) {
    history_.forgetFrom(frame);
    probe_.reset();
  }
  /// Another run goes on from `frame`: no copy made so far is of use to it.
  void forgetCopies() {
    history_.forgetCopies();
    probe_.reset();
  }
  /// As History::beginTails().
  void beginTails(std::int64_t frame) { history_.beginTails(frame); }

  /// A run of its own, brought to what `run` was after this frame of the past: for likelihood maps
  /// and motion masks, of which nothing is kept. Null when that cannot be, or `goOn` said no.
  const TrackingRun* runAt(std::int64_t frame, const TrackingRun& run, const GoOn& goOn);
  /// The number of threads that share the work of the run of runAt() from now on.
  void setThreadCount(int threadCount);

private:
  /// Brings a run to a copy from before `frame`, or to the method's beginning when it cannot be
  /// copied; `next` is the frame it begins next. False: it begins again at `frame`.
  bool bringNear(TrackingRun& run, std::int64_t frame, std::int64_t& next) const;
  /// Tracks one frame of the past again, with the changes that were made meanwhile.
  Status repeat(TrackingRun& run, const TrackedFrame& trackedFrame);

  bool live_;
  History history_;
  std::unique_ptr<FrameCache> cache_;
  std::optional<TrackingRun> probe_;      ///< of runAt()
  std::optional<std::int64_t> probeNext_; ///< the frame it would begin next
};

} // namespace dewpoint::session
