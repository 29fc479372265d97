// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <functional>
#include <mutex>
#include <utility>

namespace dewpoint::session {

/// Function that receives every frame set that the tracking thread takes from the source, in order
/// and without omissions. Frames that are tracked again are not repeated. The function is called in
/// the tracking thread, so it must return immediately (for example, after queuing the set) and must
/// not throw. Use a tap where every frame is needed, as in the detection of a calibration board.
/// Views use Workbench::connectView, which delivers only the newest snapshot.
using FrameTap = std::function<void(const FrameSetPtr&)>;

/// Holds a frame tap (function that receives every frame set taken from the source). Any thread may
/// set the tap.
class FrameTapSlot {
public:
  /// Sets the frame tap, the function that receives every frame set; an empty function removes the
  /// tap. After this call returns, the former tap is not called again.
  void set(FrameTap tap) {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  /// Passes a frame set to the frame tap (the function that receives every frame set), if there is
  /// one.
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
