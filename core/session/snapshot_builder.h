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
  /// True to fill TrackSnapshot::masks: the pixels with the color of each target.
  bool includesMasks = false;
  bool includesMaps =
      false; ///< true to fill TargetSnapshot::maps: the likelihood around each target
  bool includesBodyShapes = false; ///< true to fill TargetSnapshot::shape: the shapes of people
};

/// Builds snapshots of one frame: the current frame of the run, or a past one. Both kinds have the
/// same content.
class SnapshotBuilder {
public:
  explicit SnapshotBuilder(TruthTable truth) : truth_(std::move(truth)) {}

  SnapshotOptions& options() { return options_; }
  const TruthTable& truth() const { return truth_; }

  /// Fills `snapshot` with the current frame of the run. `history` is the history of the run, or
  /// null if none is kept. `isRecorded` is true if the history already contains the current
  /// estimates.
  void fillFromCurrentFrame(const TrackingRun& run, const History* history, bool isRecorded,
                            TrackSnapshot& snapshot) const;
  /// Fills `snapshot` with a frame other than the current one. If `quickly` is true, the images may
  /// be previews (small images scaled up). Returns an error if the frame cannot be read.
  Status fillFromPastFrame(const TrackingRun& run, TimeTravel& travel, std::int64_t frame,
                           bool quickly, TrackSnapshot& snapshot) const;
  /// Fills in the parts of `snapshot` that do not depend on the frame, such as the rig and the
  /// method.
  static void fillFromDefinition(const RunDefinition& definition, TrackSnapshot& snapshot);
  /// Fills `snapshot` with any frame that can be shown, including the current one, with the maps
  /// and masks that the options request. Returns NotFound, Canceled (if `shouldContinue` returned
  /// false), or an error of reading the frame.
  Status fillFromAnyFrame(const TrackingRun& run, TimeTravel& travel, std::int64_t frame,
                          const TimeTravel::ShouldContinue& shouldContinue,
                          TrackSnapshot& snapshot) const;
  /// Returns whether the snapshot shows a past frame without the maps or masks that the options
  /// request and that only addMaps() can provide.
  bool lacksMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;
  /// Adds the data about the current frame that only the run has: likelihood maps, or motion masks
  /// for methods for people.
  void addMaps(const TrackingRun& run, TrackSnapshot& snapshot) const;

private:
  /// Adds the content that every snapshot has. `tailEnd` is the last frame whose position is part
  /// of the targets' tails (their drawn recent paths).
  static void show(const TrackedFrame& trackedFrame, const TrackingRun& run, const History* history,
                   std::int64_t tailEnd, TrackSnapshot& snapshot);
  /// Adds histograms and masks, which are computed from the images of a frame, and also body shapes
  /// and true positions.
  void addImages(const TrackingRun& run, TrackSnapshot& snapshot) const;
  /// Returns whether the options request content that only addMaps() can provide.
  bool requestsMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const;

  TruthTable truth_;
  SnapshotOptions options_;
};

} // namespace dewpoint::session
