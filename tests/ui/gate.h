// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <condition_variable>
#include <mutex>

namespace dewpoint::tests::test {

/// Holds threads up until it is opened: a disk that does not answer, a stream that hangs.
class Gate {
public:
  /// Waits until the gate is open.
  void pass() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    opened_.wait(lock, [this] { return open_; });
    --waiting_;
  }
  /// Lets everybody through, also those who come later.
  void open() {
    const std::scoped_lock lock(mutex_);
    open_ = true;
    opened_.notify_all();
  }
  int waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_;
  }

private:
  mutable std::mutex mutex_;
  std::condition_variable opened_;
  bool open_ = false;
  int waiting_ = 0;
};

} // namespace dewpoint::tests::test
