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
  /// A frame set was taken from the source; the run has not seen it yet.
  virtual void taken(const FrameSet& /*frames*/) {}
  /// An iteration was made, which took these microseconds per target.
  virtual void iterated(const TrackingRun& /*run*/, double /*microseconds*/) {}
  /// All iterations of the frame were made. An error ends the loop.
  virtual Status tracked(const TrackingRun& /*run*/) { return {}; }
};
using FrameObservers = std::span<FrameObserver* const>;

enum class FrameStep { WholeFrame, OneIteration };

/// Makes the iterations that are left of the frame that the run has begun, or only the next one,
/// and calls the observers in their order. Returns whether the frame is done, or the first error
/// that one of them returns.
Result<bool> trackFrame(TrackingRun& run, FrameObservers observers,
                        FrameStep step = FrameStep::WholeFrame);
/// The whole frame that the run has begun.
Status trackOneFrame(TrackingRun& run, FrameObservers observers);
/// Takes a frame set and begins it first.
Status trackOneFrame(TrackingRun& run, FrameSetPtr frames, FrameObservers observers);

/// Whether a camera delivered an image; a live source returns sets without any when nothing came.
bool hasImages(const FrameSet& frames);

/// Frames `first` to `end` - 1 of a source; to its last one where there is no `end`.
struct FrameRange {
  std::int64_t first = 0;
  std::optional<std::int64_t> end;

  /// How many frame sets a source has of them; nothing when that is not known beforehand.
  std::optional<std::int64_t> count(const FrameSetSource& source) const;
};

/// Tracks frames of a source until they are all done, an error comes up, or `goOn`, which is called
/// before each frame, returns false.
Status trackFrames(FrameSetSource& source, const FrameRange& range, TrackingRun& run,
                   FrameObservers observers, const std::function<bool()>& goOn);

} // namespace dewpoint::session
