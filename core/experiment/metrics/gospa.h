// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <span>

namespace dewpoint::experiment {

/// Parameters of the GOSPA metric.
struct GospaSetup {
  /// Largest distance of an assigned pair, meters; a pair farther apart counts as one missed and
  /// one false target.
  double cutoff = 0.1;
  double order = 2.0; ///< exponent p, at least 1
};

/// Generalized optimal sub-pattern assignment metric between two sets of points, alpha = 2
/// (Rahmathullah, Garcia-Fernandez & Svensson 2017, proposition 1): distance^p = sum over the
/// assigned pairs of d^p + cutoff^p / 2 * (missed + false).
struct Gospa {
  double distance = 0.0; ///< GOSPA distance, meters
  /// Contributions of the three kinds of errors (localization errors, missed targets and false
  /// targets) to distance^p, in meters^p.
  double localizationCost = 0.0;
  double missedTargetCost = 0.0;
  double falseTargetCost = 0.0;
  int missedTargetCount = 0;
  int falseTargetCount = 0;
};

/// GOSPA averaged over frames. The three contributions (localizationCost, missedTargetCost and
/// falseTargetCost) add up to powerMean^p.
struct GospaAverage {
  double mean = 0.0;      ///< mean distance, meters
  double powerMean = 0.0; ///< p-th root of the mean of distance^p, meters
  double localizationCost = 0.0;
  double missedTargetCost = 0.0;
  double falseTargetCost = 0.0;
  double missedTargetsPerFrame = 0.0;
  double falseTargetsPerFrame = 0.0;
};

/// Returns the GOSPA metric between the true targets and the estimates of one frame. Identities are
/// ignored.
Gospa computeGospa(const TrackFrame& frame, const GospaSetup& setup);

/// Returns the GOSPA metric averaged over frames; all values are zero if there are no frames.
GospaAverage averageGospa(std::span<const TrackFrame> frames, const GospaSetup& setup);

} // namespace dewpoint::experiment
