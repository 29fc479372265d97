// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot_publisher.h"

#include <utility>

namespace dewpoint::session {

void SnapshotPublisher::onSnapshot(std::function<void()> wake) {
  const std::lock_guard lock(wakeMutex_);
  wake_ = std::move(wake);
}

void SnapshotPublisher::publish(TrackSnapshotPtr snapshot) {
  {
    const std::lock_guard lock(newestMutex_);
    newest_ = std::move(snapshot);
  }
  // The wake-up runs under its lock: after onSnapshot(nullptr) returns it is never called again.
  const std::lock_guard lock(wakeMutex_);
  if (wake_) {
    wake_();
  }
}

TrackSnapshotPtr SnapshotPublisher::newestSnapshot() const {
  const std::lock_guard lock(newestMutex_);
  return newest_;
}

} // namespace dewpoint::session
