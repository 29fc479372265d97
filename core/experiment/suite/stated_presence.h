// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

namespace dewpoint::experiment {

/// Returns whether an estimate reports that its target is present: it has a position, and either it
/// is valid or its existence probability is above one half.
inline bool reportsPresence(const SphereEstimate& estimate) {
  return estimate.mean.allFinite() && (estimate.valid || estimate.existenceProbability > 0.5);
}

} // namespace dewpoint::experiment
