// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cmath>

namespace dewpoint::observation {

/// What one camera alone says about a target being at one place.
struct CameraEvidence {
  bool inView = false;        ///< there is an image, and the place lies within it
  double logLikelihood = 0.0; ///< by the method's own observation model; 0 when it did not look
  double existence = 0.5; ///< that the target is there, by this camera alone and even odds before
  double visible = 0.0;   ///< share of the target's outline (or window) in its color, 0 to 1
};

/// Probability of a thing whose odds were even before the evidence: 1 / (1 +
/// exp(-logLikelihoodRatio)).
inline double probabilityFrom(double logLikelihoodRatio) {
  return 1.0 / (1.0 + std::exp(-logLikelihoodRatio));
}

} // namespace dewpoint::observation
