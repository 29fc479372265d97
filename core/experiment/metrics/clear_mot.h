// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// CLEAR MOT counts of a sequence (Bernardin & Stiefelhagen 2008, section 2.1). A true target and
/// an estimate can match only if their distance in space is at most the gate. Fragmentations are
/// counted as defined by Milan et al. 2016 (MOT16).
struct ClearMot {
  std::int64_t truthCount = 0; ///< number of true targets, summed over the frames
  std::int64_t matches = 0;
  std::int64_t misses = 0;
  std::int64_t falsePositives = 0;
  /// Number of times that a true target was matched to a different estimate identity than at its
  /// previous match.
  std::int64_t identitySwitches = 0;
  /// Number of times that a true target was matched again after frames in which it was present but
  /// not matched.
  std::int64_t fragmentations = 0;
  double distanceSum = 0.0; ///< sum of the distances of all matches, meters

  /// Returns the multiple object tracking accuracy (equation 2). It is at most 1 and may be
  /// negative. Returns NaN if there are no true targets.
  double mota() const;
  /// Returns the multiple object tracking precision (equation 1), the mean distance of the matches
  /// in meters. Returns NaN if there are no matches.
  double motp() const;
};

/// Computes the CLEAR MOT counts of a sequence. Frames must be in order. A match between a true
/// target and an estimate is kept in the next frame while both are present and no farther apart
/// than `gate` (meters), even if another estimate is nearer. The remaining points are matched
/// again. Among the matchings with the largest number of pairs, the one with the smallest total
/// distance is used. While a true target is not matched, the identity of its last match is
/// remembered.
ClearMot computeClearMot(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
