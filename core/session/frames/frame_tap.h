// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <functional>
#include <mutex>
#include <utility>

namespace dewpoint::session {

/// Is given every frame set that the tracking thread takes, in order, none left out; frames that
/// are tracked again are not given again. Called in the tracking thread: it must return at once
/// (hand the set to a queue) and must not throw.
/// It is for whoever may miss no frame (a board or a wand that is searched for); views are
/// connected by Workbench::connectView, and get the newest snapshot.
using FrameTap = std::function<void(const FrameSetPtr&)>;

/// Holds a tap, which may be set from any thread.
class FrameTapSlot {
public:
  /// An empty one ends it; when this returns, the former one is not called any more.
  void set(FrameTap tap) {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  void give(const FrameSetPtr& frames) {
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
