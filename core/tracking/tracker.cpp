// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/tracker.h"

namespace dewpoint::tracking {

std::vector<TrackEstimate> estimatesOf(const Tracker& tracker) {
  std::vector<TrackEstimate> estimates;
  estimates.reserve(tracker.trackCount());
  for (std::size_t track = 0; track < tracker.trackCount(); ++track) {
    estimates.push_back(tracker.estimate(track));
  }
  return estimates;
}

} // namespace dewpoint::tracking
