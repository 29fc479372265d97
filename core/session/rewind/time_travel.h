// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/frame_cache.h"
#include "core/session/rewind/history.h"
#include "core/session/snapshot/snapshot.h"

#include <functional>
#include <memory>
#include <optional>

namespace dewpoint::session {

/// Makes earlier frames of a run available. It provides their images and results, and restores the
/// run to its state before a frame, from which tracking continues with bit-identical results. Used
/// by the tracking thread only.
class TimeTravel {
public:
  /// Creates an empty history. Recorded frames are read again from `source`, which must outlive
  /// this object; its position changes. `bytes` limits the total memory.
  TimeTravel(FrameSetSource& source, std::size_t bytes);

  /// Removes all images, results and saved states of past frames, for a new run.
  void clear();
  /// Stores the images of a frame set. Must be called before the run begins this frame set.
  void noteFrameBegin(const FrameSetPtr& frames, const TrackingRun& run);
  /// Stores a change that was made to the run in its current frame.
  void recordChange(const TrackingRun& run, const RunChange& change);
  /// Stores the results of the run's current frame and returns them. Must be called when the frame
  /// is finished, and again after each further iteration on this frame.
  const TrackedFrame& record(const TrackingRun& run);

  /// Returns the images of a frame; null if there are none, or if they have been dropped to save
  /// memory.
  Result<FrameSetPtr> framesAt(std::int64_t frame) { return cache_->at(frame); }
  /// Returns the frame closest to this one that can be shown; nothing before the first frame.
  std::optional<std::int64_t> nearestFrame(std::int64_t frame) const;
  /// Returns the next frame after this one that can be shown; nothing at the end.
  std::optional<std::int64_t> nextShowable(std::int64_t frame) const;
  /// Returns the images of a frame like framesAt(), but small images scaled up if the full ones are
  /// not available immediately. Sets `preview` to true in this case.
  Result<FrameSetPtr> previewAt(std::int64_t frame, bool& preview);
  /// Returns the range of frames that can be shown, and the memory used for them.
  HistoryState state() const;
  const History& history() const { return history_; }

  /// Returns whether to continue a long operation.
  using ShouldContinue = std::function<bool()>;
  /// Restores `run` to its state right before it began `frame`, by tracking again from the nearest
  /// checkpoint (saved state) with the settings used at that time. If there is no checkpoint before
  /// the frame, `run` starts from scratch at the frame. Nothing is removed from the history.
  /// Returns the frame reached: `frame`, or an earlier one if `shouldContinue` returned false.
  Result<std::int64_t> goBack(TrackingRun& run, std::int64_t frame,
                              const ShouldContinue& shouldContinue);
  /// Removes the results of this frame and of later ones.
  void forgetFrom(std::int64_t frame) {
    history_.forgetFrom(frame);
    probe_.reset();
  }
  /// Removes all checkpoints (saved states). Call this when another run continues from the current
  /// frame.
  void removeCheckpoints() {
    history_.removeCheckpoints();
    probe_.reset();
  }
  /// Makes the tails (drawn recent paths) of targets begin at this frame.
  void startTailsAt(std::int64_t frame) { history_.startTailsAt(frame); }

  /// Returns a separate run in the state that `run` had after the past frame `frame`. Use it to get
  /// likelihood maps and motion masks, which the history does not store. Null if the state cannot
  /// be restored, or if `shouldContinue` returned false.
  const TrackingRun* runAt(std::int64_t frame, const TrackingRun& run,
                           const ShouldContinue& shouldContinue);
  /// Sets the number of filter threads of the run returned by runAt().
  void setThreadCount(int threadCount);

private:
  /// Restores a run from the last checkpoint at or before `frame`, or, if the method cannot be
  /// copied, from the frame at which the method began. Sets `next` to the frame that the run must
  /// begin next. Returns false if there is neither, so that the run starts from scratch at `frame`.
  bool restoreCheckpoint(TrackingRun& run, std::int64_t frame, std::int64_t& next) const;
  /// Tracks one past frame again, with the changes made during it.
  Status trackAgain(TrackingRun& run, const TrackedFrame& trackedFrame);

  History history_;
  std::unique_ptr<FrameCache> cache_;
  LiveFrameCache* liveCache_ = nullptr;   ///< the same cache; null for a recording
  std::optional<TrackingRun> probe_;      ///< run of runAt()
  std::optional<std::int64_t> probeNext_; ///< next frame that the probe would begin
};

} // namespace dewpoint::session
