// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker.h"

#include <cmath>
#include <cstddef>
#include <variant>

namespace dewpoint::tests {

/// What is believed of a track that is a sphere; throws when it is something else.
inline SphereEstimate sphereOf(const Tracker& tracker, std::size_t track = 0) {
  return std::get<SphereEstimate>(tracker.estimate(track));
}

inline bool isFinite(const SphereEstimate& e) {
  return e.mean.allFinite() && e.best.allFinite() && e.covariance.allFinite() &&
         std::isfinite(e.existenceProbability) && std::isfinite(e.effectiveSampleSize) &&
         std::isfinite(e.radius) && e.existenceProbability >= 0.0 && e.existenceProbability <= 1.0;
}

} // namespace dewpoint::tests
