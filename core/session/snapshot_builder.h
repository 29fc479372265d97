// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/time_travel.h"
#include "core/session/run/tracking_run.h"
#include "core/session/snapshot/snapshot.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Optional contents of snapshots; each takes computing time.
struct SnapshotOptions {
  bool masks = false;  ///< TrackSnapshot::masks
  bool maps = false;   ///< TargetSnapshot::maps
  bool shapes = false; ///< TargetSnapshot::shape
};

/// Builds snapshots of one frame: the current frame of the run, or a past one. Both are first
/// converted to a TrackedFrame, so the same content is shown for both.
class SnapshotBuilder {
public:
  explicit SnapshotBuilder(TruthTable truth) : truth_(std::move(truth)) {}

  SnapshotOptions& options() { return options_; }
  const TruthTable& truth() const { return truth_; }

  /// Shows the current frame of the run. `history` is null if none is kept; `isRecorded` states
  /// whether it contains the current estimates.
  void showHead(const TrackingRun& run, const History* history, bool isRecorded,
                TrackSnapshot& snapshot) const;
  /// Shows another frame, with `quickly` possibly as a preview. Fails if the frame cannot be read.
  Status showPast(const TrackingRun& run, TimeTravel& travel, std::int64_t frame, bool quickly,
                  TrackSnapshot& snapshot) const;
  /// Returns whether the options request content of a past frame that only addMaps() can provide.
  bool lacksMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;
  /// Adds what only the run itself knows about its current frame: likelihood maps, or motion masks
  /// with methods for people.
  void addMaps(const TrackingRun& run, TrackSnapshot& snapshot) const;

private:
  /// Adds what every snapshot shows of a frame; `tailEnd` is the last frame of the tails.
  static void show(const TrackedFrame& trackedFrame, const TrackingRun& run, const History* history,
                   std::int64_t tailEnd, TrackSnapshot& snapshot);
  /// Adds what every frame shows of its images.
  void addImages(const TrackingRun& run, TrackSnapshot& snapshot) const;
  /// Returns whether the options request content that only addMaps() can provide.
  bool wantsMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;

  TruthTable truth_;
  SnapshotOptions options_;
};

} // namespace dewpoint::session
