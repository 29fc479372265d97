// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/metrics/clear_mot.h"
#include "core/experiment/metrics/gospa.h"
#include "core/experiment/metrics/hota.h"
#include "core/experiment/metrics/track_frame.h"
#include "core/trajectory/trajectory.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Options for comparing several targets whose names in the estimate and in the truth are
/// unrelated.
struct IdentityComparison {
  double gate = 0.5;          ///< largest distance of a match, and the GOSPA cutoff, meters
  bool ignoresHeight = false; ///< true: positions are compared on the floor, without z
};

/// Converts an estimated trajectory and the truth to frames for the multi-target metrics. Only
/// valid samples with a finite position are used. Each target name gets an identity number, in
/// order of appearance. Frames are matched by number; a frame that only one of the trajectories
/// contains is included. Returns Mismatch if a trajectory has no frame numbers, or if there is no
/// common frame.
Result<std::vector<TrackFrame>> makeTrackFrames(const Trajectory& estimate, const Trajectory& truth,
                                                const IdentityComparison& comparison);

/// Result of comparing several targets.
struct IdentityEvaluation {
  IdentityComparison comparison;
  std::int64_t frameCount = 0;
  ClearMot clearMot;
  Hota hota;
  GospaAverage gospa; ///< GOSPA of order 2
};

/// Compares an estimated trajectory of several targets with the truth. Returns Mismatch if a
/// trajectory has no frame numbers, or if there is no common frame.
Result<IdentityEvaluation> evaluateIdentities(const Trajectory& estimate, const Trajectory& truth,
                                              const IdentityComparison& comparison);

/// Returns the text that `dewpoint-cli evaluate --identities` prints, with lengths in meters and
/// millimeters.
std::string identityText(const IdentityEvaluation& evaluation);
/// Returns the result of comparing several targets with the truth as JSON.
nlohmann::json identityJson(const IdentityEvaluation& evaluation);

} // namespace dewpoint::experiment
