// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::session {

/// The newest snapshot, and whom to wake when there is one. Every call may come from any thread.
class SnapshotPublisher {
public:
  /// Whom to wake from now on, nobody if `wake` is empty: once this has returned, whoever was woken
  /// before is never called again. `wake` may read `newest`, but neither publish nor call this.
  void onSnapshot(std::function<void()> wake);
  void publish(TrackSnapshotPtr snapshot);
  TrackSnapshotPtr newest() const;

private:
  mutable std::mutex newestMutex_;
  TrackSnapshotPtr newest_ = std::make_shared<const TrackSnapshot>();
  std::mutex wakeMutex_; ///< held while `wake_` runs; apart, so that `wake_` can read the newest
  std::function<void()> wake_;
};

} // namespace dewpoint::session
