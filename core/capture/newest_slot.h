// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

namespace dewpoint::capture {

/// Holds one value between two threads: a new one replaces one nobody took, which counts as
/// dropped. Every function may be called from any thread.
template <class T> class NewestSlot {
public:
  using Clock = std::chrono::steady_clock;

  void put(T value) {
    std::scoped_lock lock(mutex_);
    if (value_) {
      ++dropped_;
    } else {
      fullSince_ = Clock::now();
    }
    value_ = std::move(value);
  }

  /// The newest value, once.
  std::optional<T> take() {
    std::scoped_lock lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

  /// Since when something has been waiting here (not when the newest came); nothing when empty.
  std::optional<Clock::time_point> fullSince() const {
    std::scoped_lock lock(mutex_);
    return value_ ? std::optional(fullSince_) : std::nullopt;
  }

  std::int64_t dropped() const {
    std::scoped_lock lock(mutex_);
    return dropped_;
  }

private:
  mutable std::mutex mutex_;
  std::optional<T> value_;
  Clock::time_point fullSince_{};
  std::int64_t dropped_ = 0;
};

} // namespace dewpoint::capture
