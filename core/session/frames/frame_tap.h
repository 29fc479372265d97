// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <functional>
#include <mutex>
#include <utility>

namespace dewpoint::session {

/// Receives every frame set that the tracking thread takes from the source, in order and without
/// omissions. Frames that are tracked again are not repeated. It is called in the tracking thread,
/// so it must return immediately (for example, by queuing the set) and must not throw. It is
/// intended for consumers that need every frame, such as the detection of a board or wand. Views
/// use Workbench::connectView, which delivers only the newest snapshot.
using FrameTap = std::function<void(const FrameSetPtr&)>;

/// Holds a tap, which any thread may set.
class FrameTapSlot {
public:
  /// Sets the tap; an empty one removes it. After this returns, the former tap is not called again.
  void set(FrameTap tap) {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  /// Passes a frame set to the tap, if there is one.
  void deliver(const FrameSetPtr& frames) {
    const std::lock_guard lock(mutex_);
    if (tap_) {
      tap_(frames);
    }
  }

private:
  std::mutex mutex_;
  FrameTap tap_;
};

} // namespace dewpoint::session
