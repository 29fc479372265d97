// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/time.h"
#include "core/capture/frame_source.h"
#include "core/session/snapshot/snapshot.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Source of a run's frames, with the time and the camera problems that the source has reported.
/// Used by the tracking thread only.
class RunInput {
public:
  /// Creates the input from `source`. If `source` is null, only hasSource() and latestFrameTime()
  /// may be called.
  explicit RunInput(std::unique_ptr<FrameSetSource> source) : source_(std::move(source)) {}

  bool hasSource() const { return source_ != nullptr; }
  FrameSetSource& source() { return *source_; }
  bool isLive() const { return source_->isLive(); }
  double framesPerSecond() const { return source_->framesPerSecond(); }
  std::optional<std::int64_t> frameCount() const { return source_->frameCount(); }

  /// Returns the next frame set of live cameras (FrameSetSource::next()).
  Result<FrameSetPtr> next() { return source_->next(); }
  /// Goes back to the first frame of the source, and resets latestFrameTime() to 0.
  Status restart() {
    time_ = 0.0;
    return source_->seek(0);
  }
  /// Updates latestFrameTime() after a frame set was taken from the source.
  void noteTaken(const FrameSet& taken) { time_ = std::max(time_, seconds(taken.time)); }
  /// Returns the latest time of the frames taken since the last start or restart, in seconds.
  double latestFrameTime() const { return time_; }

  /// Returns the current problems of live cameras.
  std::vector<Error> notices() const { return source_->notices(); }
  /// Returns whether the problems of live cameras have changed since they were last stored in a
  /// snapshot (fillSourceFields()).
  bool haveNoticesChanged() const { return notices() != shownNotices_; }
  /// Stores the current problems, the number of frames, the frame rate and the number of dropped
  /// frames in a snapshot.
  void fillSourceFields(TrackSnapshot& snapshot) {
    shownNotices_ = notices();
    std::ranges::copy(shownNotices_, std::back_inserter(snapshot.notices));
    snapshot.frameCount = source_->frameCount();
    snapshot.sourceFramesPerSecond = source_->framesPerSecond();
    snapshot.droppedFrameCount = source_->droppedFrameCount();
  }

private:
  std::unique_ptr<FrameSetSource> source_;
  std::vector<Error> shownNotices_; ///< in the last snapshot
  double time_ = 0.0;               ///< seconds
};

} // namespace dewpoint::session
