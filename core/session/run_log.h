// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot.h"
#include "core/trajectory/trajectory.h"

#include <functional>
#include <mutex>
#include <vector>

namespace dewpoint {

/// What happened since the (re)start, written by the tracking thread and copied out by others.
class RunLog {
public:
  struct Piece {
    std::vector<IterationRecord> records;
    bool restarted = false;
  };
  void restart(TrajectoryHeader header);
  void append(const std::vector<IterationRecord>& records);
  /// Samples of one frame; they replace those of the same frame, if it was the last one.
  void append(const std::vector<TrajectorySample>& samples);
  /// Records from `position` on; both arguments move along. Old records are dropped in bulk when
  /// there are more than about 200,000.
  Piece since(std::uint64_t& generation, std::size_t& position) const;
  Trajectory trajectory() const;

private:
  mutable std::mutex mutex_;
  std::uint64_t generation_ = 1;
  std::size_t dropped_ = 0;
  std::vector<IterationRecord> records_;
  Trajectory trajectory_;
};

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

} // namespace dewpoint
