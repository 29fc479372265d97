// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Frames per second where neither the project nor the source states them. Origin not recorded.
inline constexpr double kDefaultFramesPerSecond = 30;

/// Frame sets of all cameras, one after the other. Implementations turn every exception of the
/// libraries they use into an Error. Used by one thread only.
class FrameSetSource {
public:
  virtual ~FrameSetSource() = default;
  /// Frames in the recording (the shortest camera's); nothing when live.
  virtual std::optional<std::int64_t> frameCount() const = 0;
  virtual double framesPerSecond() const = 0;
  bool isLive() const { return !frameCount().has_value(); }
  /// The next frame set; a null pointer at the regular end. Live: waits at most about 100 ms and
  /// returns a set without images (every frame null) when nothing came.
  virtual Result<FrameSetPtr> next() = 0;
  /// Makes `frame` the next one. Live sources ignore it.
  virtual Status seek(std::int64_t frame) = 0;
  /// Frames a live camera took that were replaced by newer ones before they were taken.
  virtual std::int64_t droppedFrames() const { return 0; }
  /// Sentences worth saying that do not stop the run (videos of different length, a camera lost).
  virtual std::vector<Error> notices() const { return {}; }
};

} // namespace dewpoint::capture
