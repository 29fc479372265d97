// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot_publisher.h"

#include <utility>

namespace dewpoint::session {

void SnapshotPublisher::onSnapshot(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

void SnapshotPublisher::publish(TrackSnapshotPtr snapshot) {
  // The wake-up runs under the lock: after onSnapshot(nullptr) returns it is never called again.
  const std::lock_guard lock(mutex_);
  newest_ = std::move(snapshot);
  if (wake_) {
    wake_();
  }
}

TrackSnapshotPtr SnapshotPublisher::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

} // namespace dewpoint::session
