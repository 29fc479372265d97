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

/// How to compare several targets whose names in estimate and truth are unrelated.
struct IdentityComparison {
  double gate = 0.5;   ///< meters; largest distance of a match, and the cutoff of GOSPA
  bool ground = false; ///< compare positions on the floor, without z
};

/// Converts a trajectory and the truth to frames: valid samples with a position; identities are
/// numbered by target name in the order of appearance. Frames are matched by number, and frames of
/// either trajectory count. Mismatch if one has no frame numbers, or no frame is common.
Result<std::vector<TrackFrame>> trackFrames(const Trajectory& estimate, const Trajectory& truth,
                                            const IdentityComparison& comparison);

/// Result of the comparison of several targets.
struct IdentityEvaluation {
  IdentityComparison comparison;
  std::int64_t frames = 0;
  ClearMot clear;
  Hota hota;
  GospaAverage gospa; ///< of order 2
};

/// Evaluates a trajectory; errors as in trackFrames().
Result<IdentityEvaluation> evaluateIdentities(const Trajectory& estimate, const Trajectory& truth,
                                              const IdentityComparison& comparison);

/// Text that `dewpoint-cli evaluate --identities` prints; meters and millimeters.
std::string identityText(const IdentityEvaluation& evaluation);
/// The same evaluation as JSON.
nlohmann::json identityJson(const IdentityEvaluation& evaluation);

} // namespace dewpoint::experiment
