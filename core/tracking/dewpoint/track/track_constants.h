// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

// What a target that is followed as a ball (BernoulliTrack) and one that is followed as a region
// (RegionTrack) have in common. Reasons: docs/method-dewpoint.md, sections 3, 5 and 6; those
// without a derivation are judgments.

/// Probability that an absent target appears within one frame.
inline constexpr double kBirthProbability = 0.2;
/// m/s, standard deviation of a new hypothesis' velocity along each axis.
inline constexpr double kBirthSpeed = 1.5;
/// Least log likelihood ratio of a birth.
inline constexpr double kMinLogLikelihoodRatio = 2.0;
/// Probability of a hypothesis at a given position. Origin not recorded.
inline constexpr double kInitialProbability = 0.98;
/// Least probability of absence, so that it has a logarithm. Origin not recorded.
inline constexpr double kMinAbsence = 1e-9;
/// Standard deviations from the prediction; what is found farther off belongs to another object.
inline constexpr double kGate = 5.0;
/// Standard deviations between measurement and prediction beyond which the learned process noise
/// does not explain the motion: a maneuver.
inline constexpr double kManeuverGate = 4.0;
/// 1/m², added to an information matrix so that it can be inverted: one meter. Origin not recorded.
inline constexpr double kMinInformation = 1.0;

} // namespace dewpoint::tracking
