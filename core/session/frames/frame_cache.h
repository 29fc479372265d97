// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::session {

/// The images of frames that went by, by number. Used by one thread.
class FrameCache {
public:
  virtual ~FrameCache() = default;
  /// A frame set that was taken from the source; numbers only rise.
  virtual void add(const FrameSetPtr& frames) = 0;
  /// The images of this frame; null when they were dropped (live), or not there.
  virtual Result<FrameSetPtr> at(std::int64_t frame) = 0;
  /// A preview of a frame: in full when that takes no time, else small and scaled up (`exact` is
  /// false then); null when there is none.
  virtual FrameSetPtr previewAt(std::int64_t frame, bool& exact) = 0;
  /// The oldest frame that at() still has.
  virtual std::int64_t oldest() const = 0;
  /// The newest frame that at() has.
  virtual std::int64_t newest() const = 0;
  virtual std::size_t bytes() const = 0;
  /// Forgets everything (the run begins again).
  virtual void clear() = 0;
};

/// Bytes of the pixels.
std::size_t bytesOf(const FrameSet& frames);

} // namespace dewpoint::session
