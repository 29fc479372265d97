// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace dewpoint::capture {

/// Queue that passes frames of one camera from its thread to a reader, in order. If the reader
/// falls behind, the oldest frames are dropped. All functions may be called from any thread.
class FrameQueue {
public:
  /// Creates an empty queue. `capacity`: maximum number of waiting frames.
  explicit FrameQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Appends a frame. If the queue is full, drops the oldest waiting frame.
  void put(FramePtr frame) {
    std::scoped_lock lock(mutex_);
    if (frames_.size() == capacity_) {
      frames_.pop_front();
      ++dropped_;
    }
    frames_.push_back(std::move(frame));
  }

  /// Removes and returns all waiting frames, oldest first.
  std::vector<FramePtr> takeAll() {
    std::scoped_lock lock(mutex_);
    std::vector<FramePtr> taken(frames_.begin(), frames_.end());
    frames_.clear();
    return taken;
  }

  /// Returns the number of frames dropped so far.
  std::int64_t droppedCount() const {
    std::scoped_lock lock(mutex_);
    return dropped_;
  }

private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::deque<FramePtr> frames_;
  std::int64_t dropped_ = 0;
};

} // namespace dewpoint::capture
