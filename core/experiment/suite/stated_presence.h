// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

namespace dewpoint::experiment {

/// Whether an estimate says that its target is there: it has a position, and is valid or believes
/// in the target with more than one half.
inline bool statesPresence(const SphereEstimate& estimate) {
  return estimate.mean.allFinite() && (estimate.valid || estimate.existenceProbability > 0.5);
}

} // namespace dewpoint::experiment
