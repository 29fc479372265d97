// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Frame rate (frames per second) used if neither the project nor the source specifies one. The
/// reason for this value is not known.
inline constexpr double kDefaultFramesPerSecond = 30;

/// Source of frame sets, delivered one after the other. Implementations convert all exceptions of
/// libraries to an Error. For use by one thread only.
class FrameSetSource {
public:
  virtual ~FrameSetSource() = default;
  /// Returns the number of frames in the recording, or nothing for a live source. If the cameras
  /// differ in length, this is the number of the shortest one.
  virtual std::optional<std::int64_t> frameCount() const = 0;
  /// Returns the frame rate in frames per second.
  virtual double framesPerSecond() const = 0;
  bool isLive() const { return !frameCount().has_value(); }
  /// Returns the next frame set, or null after the last one. A live source waits at most about 100
  /// ms. If no frame arrives in that time, it returns a set in which every frame is null.
  virtual Result<FrameSetPtr> next() = 0;
  /// Makes `frame` the next frame set to be read. Ignored by live sources.
  virtual Status seek(std::int64_t frame) = 0;
  /// Returns the number of live frames that were replaced by newer ones before they were read.
  virtual std::int64_t droppedFrameCount() const { return 0; }
  /// Returns problems that do not stop the run, such as videos of different lengths or a
  /// disconnected camera.
  virtual std::vector<Error> notices() const { return {}; }
};

} // namespace dewpoint::capture
