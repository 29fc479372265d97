// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <array>
#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// Number of similarity thresholds (0.05, 0.10, ..., 0.95).
inline constexpr int kHotaThresholdCount = 19;

/// Higher order tracking accuracy at one threshold (Luiten et al. 2021). Undefined scores are NaN.
/// If there are neither true targets nor estimates, all scores are undefined. If there are no
/// matches, LocA (localization accuracy) is undefined.
struct HotaAtThreshold {
  double threshold = 0.0; ///< alpha, the minimum similarity of a match
  std::int64_t matches = 0;
  std::int64_t misses = 0;
  std::int64_t falsePositives = 0;
  double detectionAccuracy = 0.0; ///< DetA = TP / (TP + FN + FP)
  /// AssA (association accuracy): mean over the matches (TP) of TPA / (TPA + FNA + FPA); 0 if there
  /// are no matches.
  double associationAccuracy = 0.0;
  double localizationAccuracy = 0.0; ///< LocA: mean similarity of the TP
  double hota = 0.0;                 ///< sqrt(DetA * AssA)
};

/// HOTA scores at each similarity threshold, and their means over the thresholds. LocA
/// (localization accuracy) is averaged over the thresholds that have matches.
struct Hota {
  std::array<HotaAtThreshold, kHotaThresholdCount> thresholds;
  double detectionAccuracy = 0.0;
  double associationAccuracy = 0.0;
  double localizationAccuracy = 0.0;
  double hota = 0.0;
};

/// Computes HOTA (higher order tracking accuracy). The similarity of a pair of true target and
/// estimate is max(0, 1 - distance / gate); `gate` is in meters. Each frame is matched once for all
/// thresholds, as in the authors' TrackEval. The matching maximizes the sum of each pair's
/// similarity times the alignment of its two identities. The alignment measures how well two
/// identities agree over the whole sequence.
Hota computeHota(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
