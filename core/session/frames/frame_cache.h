// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::session {

/// Cache of images of past frames, by frame number. Used by one thread.
class FrameCache {
public:
  virtual ~FrameCache() = default;
  /// Adds a frame set that was taken from the source; frame numbers must increase.
  virtual void add(const FrameSetPtr& frames) = 0;
  /// Returns the images of a frame. Null if the frame does not exist, or if its images came from
  /// live cameras and were dropped to save memory. Returns an error if reading the images fails.
  virtual Result<FrameSetPtr> at(std::int64_t frame) = 0;
  /// Returns images of a frame without waiting. Returns the full images if they are available
  /// immediately (`exact` becomes true), otherwise small images scaled up (`exact` becomes false).
  /// Null if there are none.
  virtual FrameSetPtr previewAt(std::int64_t frame, bool& exact) = 0;
  /// Returns the oldest frame available from at().
  virtual std::int64_t oldestFrame() const = 0;
  /// Returns the newest frame available from at().
  virtual std::int64_t newestFrame() const = 0;
  virtual std::size_t memoryBytes() const = 0;
};

/// Cache of frames from live cameras. After a restart of the run, these cameras deliver other
/// images for the same frame numbers. A recording delivers the same images again, so its cache
/// stays valid.
class LiveFrameCache : public FrameCache {
public:
  /// Removes all frames, for a restart of the run.
  virtual void clear() = 0;
};

/// Returns the size of the pixel data of all images, in bytes.
std::size_t bytesOf(const FrameSet& frames);

} // namespace dewpoint::session
