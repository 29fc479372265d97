// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// CLEAR MOT counts of a sequence (Bernardin & Stiefelhagen 2008, section 2.1) with a gate on the
/// distance in space, and the fragmentations of Milan et al. 2016 (MOT16).
struct ClearMot {
  std::int64_t truths = 0; ///< number of truths, summed over the frames
  std::int64_t matches = 0;
  std::int64_t misses = 0;
  std::int64_t falsePositives = 0;
  /// Times that a truth was matched to another estimate's identity than at its last match.
  std::int64_t identitySwitches = 0;
  /// Times that a truth was matched again after frames in which it was present but not matched.
  std::int64_t fragmentations = 0;
  double distanceSum = 0.0; ///< over the matches, meters

  /// Multiple object tracking accuracy, equation 2: at most 1, may be negative; NaN without truths.
  double mota() const;
  /// Multiple object tracking precision, equation 1: mean distance of the matches in meters; NaN
  /// without matches.
  double motp() const;
};

/// Computes the counts. Frames must be in order. A match is kept while both are present and no
/// farther apart than `gate` (meters), even if another estimate is nearer. The remaining ones are
/// matched again: first as many pairs as possible, then the least distance. A truth keeps its last
/// identity through gaps.
ClearMot clearMot(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
