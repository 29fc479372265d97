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

/// How several targets are compared whose names have nothing to do with each other.
struct IdentityComparison {
  double gate = 0.5;   ///< meters within which an estimate belongs to a truth; cutoff of GOSPA
  bool ground = false; ///< positions are compared on the floor: z does not count
};

/// A trajectory against the truth, frame by frame: valid samples with a position, identities by
/// target name in the order of their appearance. Frames are matched by number, and those of either
/// count. Mismatch when one has no frame numbers, or no frame is common.
Result<std::vector<TrackFrame>> trackFrames(const Trajectory& estimate, const Trajectory& truth,
                                            const IdentityComparison& comparison);

struct IdentityEvaluation {
  IdentityComparison comparison;
  std::int64_t frames = 0;
  ClearMot clear;
  Hota hota;
  GospaAverage gospa; ///< order 2
};

Result<IdentityEvaluation> evaluateIdentities(const Trajectory& estimate, const Trajectory& truth,
                                              const IdentityComparison& comparison);

/// As `dewpoint-cli evaluate --identities` prints it; meters and millimeters.
std::string identityText(const IdentityEvaluation& evaluation);
nlohmann::json identityJson(const IdentityEvaluation& evaluation);

} // namespace dewpoint::experiment
