// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Frame rate (frames per second) when neither the project nor the source states one. Origin not
/// recorded.
inline constexpr double kDefaultFramesPerSecond = 30;

/// Source of the frame sets of all cameras, one after the other. Implementations convert every
/// exception of the libraries they use to an Error. Used by one thread only.
class FrameSetSource {
public:
  virtual ~FrameSetSource() = default;
  /// Number of frames in the recording (of its shortest camera); nothing for a live source.
  virtual std::optional<std::int64_t> frameCount() const = 0;
  virtual double framesPerSecond() const = 0;
  bool isLive() const { return !frameCount().has_value(); }
  /// Returns the next frame set; null at the regular end. A live source waits at most about 100 ms,
  /// and returns a set in which every frame is null when none arrived.
  virtual Result<FrameSetPtr> next() = 0;
  /// Makes `frame` the next frame set. Live sources ignore it.
  virtual Status seek(std::int64_t frame) = 0;
  /// Number of live frames that were replaced by newer ones before they were read.
  virtual std::int64_t droppedFrames() const { return 0; }
  /// Problems that do not stop the run (videos of different length, a camera that was lost).
  virtual std::vector<Error> notices() const { return {}; }
};

} // namespace dewpoint::capture
