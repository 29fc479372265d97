// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/time_travel.h"
#include "core/session/run/snapshot.h"
#include "core/session/run/tracking_run.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// What snapshots hold beside images, estimates and particles; each takes time.
struct SnapshotOptions {
  bool masks = false;  ///< TrackSnapshot::masks
  bool maps = false;   ///< TargetSnapshot::maps
  bool shapes = false; ///< TargetSnapshot::shape
};

/// Makes snapshots show one frame: the one that the run stands at, or one of the past. Both become
/// a TrackedFrame first, and what is shown of a frame is the same for all.
class SnapshotBuilder {
public:
  explicit SnapshotBuilder(TruthTable truth) : truth_(std::move(truth)) {}

  SnapshotOptions& options() { return options_; }
  const TruthTable& truth() const { return truth_; }

  /// The frame that the run stands at. `history` is null when nothing is kept; `isRecorded` says
  /// whether it has the estimates of now.
  void showHead(const TrackingRun& run, const History* history, bool isRecorded,
                TrackSnapshot& snapshot) const;
  /// Another frame; `quickly`: perhaps as a preview. Fails when it cannot be read.
  Status showPast(const TrackingRun& run, TimeTravel& travel, std::int64_t frame, bool quickly,
                  TrackSnapshot& snapshot) const;
  /// Whether something is wanted of a past frame that only addMaps() can tell.
  bool lacksMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;
  /// What the run itself has to tell of the frame it stands at: likelihood maps, or motion masks
  /// with methods for people.
  void addMaps(const TrackingRun& run, TrackSnapshot& snapshot) const;

private:
  /// What every snapshot shows of a frame; `tailEnd` is the last frame of the tails.
  static void show(const TrackedFrame& trackedFrame, const TrackingRun& run, const History* history,
                   std::int64_t tailEnd, TrackSnapshot& snapshot);
  /// What every frame shows of its images.
  void addImages(const TrackingRun& run, TrackSnapshot& snapshot) const;
  /// Whether something is wanted that only addMaps() can tell.
  bool wantsMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;

  TruthTable truth_;
  SnapshotOptions options_;
};

} // namespace dewpoint::session
