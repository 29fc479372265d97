// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/session/run/tracking_run.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace dewpoint::session {

/// Interface that receives the frames of a run as they are tracked.
class FrameObserver {
public:
  virtual ~FrameObserver() = default;
  /// Called when a frame set was taken from the source, before the run uses the set.
  virtual void onFrameTaken(const FrameSet& /*frames*/) {}
  /// Called after each filter iteration, with its duration in microseconds per target.
  virtual void onIteration(const TrackingRun& /*run*/, double /*microseconds*/) {}
  /// Called after all iterations of a frame. If it returns an error, the loop ends with this error.
  virtual Status onFrameTracked(const TrackingRun& /*run*/) { return {}; }
};
using FrameObservers = std::span<FrameObserver* const>;

/// How much of a frame is tracked in one step.
enum class FrameStep { WholeFrame, OneIteration };

/// Runs the remaining iterations of the run's current frame, or only the next iteration, and calls
/// the observers in order. Returns whether the frame is finished, or the first error of an
/// observer.
Result<bool> trackFrame(TrackingRun& run, FrameObservers observers,
                        FrameStep step = FrameStep::WholeFrame);
/// Runs all iterations of the run's current frame and calls the observers. Returns the first error
/// of an observer.
Status trackOneFrame(TrackingRun& run, FrameObservers observers);
/// Begins a frame set, runs all its iterations and calls the observers. Returns the first error of
/// an observer.
Status trackOneFrame(TrackingRun& run, FrameSetPtr frames, FrameObservers observers);

/// Returns whether the frame set contains an image from at least one camera. A live source returns
/// a set without images if none arrived.
bool hasImages(const FrameSet& frames);

/// Range of frames of a source: from `first` to `end` - 1, or to the last frame if `end` is not
/// set.
struct FrameRange {
  std::int64_t first = 0;
  std::optional<std::int64_t> end;

  /// Returns how many frames of this range a source has; nothing if the length of the source is not
  /// known.
  std::optional<std::int64_t> countIn(const FrameSetSource& source) const;
};

/// Tracks the frames of a source in a range, and calls the observers. Ends when the range is
/// finished, an error occurs, or `shouldContinue`, which is called before each frame, returns
/// false. Returns the error, if any.
Status trackFrames(FrameSetSource& source, const FrameRange& range, TrackingRun& run,
                   FrameObservers observers, const std::function<bool()>& shouldContinue);

} // namespace dewpoint::session
