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

/// Receives the frames of a run as they are tracked.
class FrameObserver {
public:
  virtual ~FrameObserver() = default;
  /// Called when a frame set has been taken from the source, before the run uses it.
  virtual void taken(const FrameSet& /*frames*/) {}
  /// Called after an iteration, with its duration in microseconds per target.
  virtual void iterated(const TrackingRun& /*run*/, double /*microseconds*/) {}
  /// Called after all iterations of a frame. An error ends the loop.
  virtual Status tracked(const TrackingRun& /*run*/) { return {}; }
};
using FrameObservers = std::span<FrameObserver* const>;

/// How much of a frame is tracked in one step.
enum class FrameStep { WholeFrame, OneIteration };

/// Runs the remaining iterations of the run's current frame, or only the next one, and calls the
/// observers in order. Returns whether the frame is finished, or the first error of an observer.
Result<bool> trackFrame(TrackingRun& run, FrameObservers observers,
                        FrameStep step = FrameStep::WholeFrame);
/// Runs all iterations of the run's current frame.
Status trackOneFrame(TrackingRun& run, FrameObservers observers);
/// Begins a frame set and runs all its iterations.
Status trackOneFrame(TrackingRun& run, FrameSetPtr frames, FrameObservers observers);

/// Returns whether at least one camera delivered an image; a live source returns sets without
/// images if none arrived.
bool hasImages(const FrameSet& frames);

/// Frames `first` to `end` - 1 of a source, or to its last frame if `end` is not set.
struct FrameRange {
  std::int64_t first = 0;
  std::optional<std::int64_t> end;

  /// Returns how many frame sets of the range a source has; nothing if this is not known
  /// beforehand.
  std::optional<std::int64_t> count(const FrameSetSource& source) const;
};

/// Tracks frames of a source until the range is finished, an error occurs, or `shouldContinue`
/// returns false. `shouldContinue` is called before each frame.
Status trackFrames(FrameSetSource& source, const FrameRange& range, TrackingRun& run,
                   FrameObservers observers, const std::function<bool()>& shouldContinue);

} // namespace dewpoint::session
