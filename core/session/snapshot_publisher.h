// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::session {

/// The newest snapshot, and whom to wake when there is one.
class SnapshotPublisher {
public:
  void onSnapshot(std::function<void()> wake);
  void publish(TrackSnapshotPtr snapshot);
  TrackSnapshotPtr newest() const;

private:
  mutable std::mutex mutex_;
  TrackSnapshotPtr newest_ = std::make_shared<const TrackSnapshot>();
  std::function<void()> wake_;
};

} // namespace dewpoint::session
