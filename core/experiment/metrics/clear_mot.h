// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// The CLEAR MOT counts of a sequence (Bernardin & Stiefelhagen 2008, section 2.1) with a gate on
/// the distance in space, and the fragmentations of Milan et al. 2016 (MOT16).
struct ClearMot {
  std::int64_t truths = 0; ///< truths, summed over the frames
  std::int64_t matches = 0;
  std::int64_t misses = 0;
  std::int64_t falsePositives = 0;
  /// A truth got another estimate's identity than it had when it was matched last.
  std::int64_t identitySwitches = 0;
  /// A truth was matched again after frames in which it was there and was not.
  std::int64_t fragmentations = 0;
  double distanceSum = 0.0; ///< over the matches, meters

  /// Multiple object tracking accuracy, equation 2; at most 1, may be negative; NaN without truths.
  double mota() const;
  /// Multiple object tracking precision, equation 1: mean distance of the matches, meters; NaN
  /// without matches.
  double motp() const;
};

/// Frames in order. A match is kept while both are there and no farther apart than `gate`, even if
/// another estimate is nearer; what is left is matched again, most pairs first, then least
/// distance. A truth remembers its last identity through gaps.
ClearMot clearMot(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
