// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::session {

/// Holds the newest snapshot and notifies a listener of new snapshots. All functions are
/// thread-safe.
class SnapshotPublisher {
public:
  /// Sets the listener `wake`; an empty function removes it. After this call returns, the former
  /// listener is never called again. `wake` may call newestSnapshot(), but neither publish() nor
  /// onSnapshot().
  void onSnapshot(std::function<void()> wake);
  /// Makes a snapshot the newest one and calls the listener.
  void publish(TrackSnapshotPtr snapshot);
  /// Returns the newest snapshot; never null.
  TrackSnapshotPtr newestSnapshot() const;

private:
  mutable std::mutex newestMutex_;
  TrackSnapshotPtr newest_ = std::make_shared<const TrackSnapshot>();
  std::mutex
      wakeMutex_; ///< held while `wake_` runs; separate, so that `wake_` can call newestSnapshot()
  std::function<void()> wake_;
};

} // namespace dewpoint::session
