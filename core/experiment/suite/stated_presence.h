// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

namespace dewpoint::experiment {

/// Returns whether an estimate declares its target present. This requires a finite position. In
/// addition, the estimate must be valid, or its existence probability must be above one half.
inline bool reportsPresence(const SphereEstimate& estimate) {
  return estimate.mean.allFinite() && (estimate.isValid || estimate.existenceProbability > 0.5);
}

} // namespace dewpoint::experiment
