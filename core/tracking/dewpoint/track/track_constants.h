// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

// Constants shared by the tracks of targets as balls (BernoulliTrack) and as regions (RegionTrack).
// For the reasons, see docs/method-dewpoint.md, sections 3, 5 and 6. Values without a derivation
// were chosen by judgment.

/// Probability that an absent target appears within one frame.
inline constexpr double kBirthProbability = 0.2;
/// Standard deviation of a new hypothesis' velocity along each axis, m/s.
inline constexpr double kBirthSpeed = 1.5;
/// Smallest log likelihood ratio at which a new hypothesis is created.
inline constexpr double kMinLogLikelihoodRatio = 2.0;
/// Probability of a hypothesis that starts at a given position. The reason for this value is not
/// recorded.
inline constexpr double kInitialProbability = 0.98;
/// Smallest probability of absence, so that its logarithm is finite. The reason for this value is
/// not recorded.
inline constexpr double kMinAbsence = 1e-9;
/// Largest distance of a detection from the prediction, in standard deviations. Detections farther
/// away belong to another object.
inline constexpr double kGate = 5.0;
/// Distance between measurement and prediction, in standard deviations, beyond which the learned
/// process noise does not explain the motion: the target has changed its velocity suddenly.
inline constexpr double kManeuverGate = 4.0;
/// Information (inverse covariance, 1/m²) added to an information matrix so that it can be
/// inverted. It corresponds to a standard deviation of one meter. The reason for this value is not
/// recorded.
inline constexpr double kMinInformation = 1.0;

} // namespace dewpoint::tracking
