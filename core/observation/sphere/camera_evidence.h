// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cmath>

namespace dewpoint::observation {

/// How well the image of one camera agrees with a target at one position.
struct CameraEvidence {
  bool isInView = false;      ///< the camera has an image into which the position projects
  double logLikelihood = 0.0; ///< log likelihood of the target at the position; 0 if not in view
  /// Posterior probability that the target is at the position, for a prior probability of one half.
  double existenceProbability = 0.5;
  /// Fraction of the area inside the target's outline that has the target color, 0 to 1. Methods
  /// with the observation model ColorWindow use its window of 5x5 pixels instead of the outline.
  double visibleShare = 0.0;
};

/// Returns the posterior probability of a hypothesis whose prior probability is one half: 1 / (1 +
/// exp(-logLikelihoodRatio)).
inline double probabilityFromLogOdds(double logLikelihoodRatio) {
  return 1.0 / (1.0 + std::exp(-logLikelihoodRatio));
}

} // namespace dewpoint::observation
