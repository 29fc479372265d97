// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/belief_region.h"
#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// An error and the covariance the method stated for it. World frame, m and m².
struct StateError {
  Eigen::Vector3d error = Eigen::Vector3d::Zero(); ///< estimate minus truth
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// As kChiSquared95ThreeDof, for 50 %: half of the errors of a consistent estimate lie within.
inline constexpr double kChiSquared50ThreeDof = 2.365973884375;

/// Do the stated covariances fit the errors? NEES is the normalized estimation error squared,
/// error^T covariance^-1 error (Bar-Shalom, Li & Kirubarajan 2001, section 5.4.2): 3 on average for
/// a consistent estimate, more for one too sure of itself.
struct Consistency {
  std::int64_t samples = 0;  ///< all that were given
  std::int64_t unusable = 0; ///< not finite, or the covariance is not positive definite
  Interval nees;             ///< mean, and the bounds a consistent filter keeps (see below)
  Eigen::Vector3d axisNees = Eigen::Vector3d::Zero(); ///< mean error² / variance per world axis
  Interval axisBounds; ///< value 1: what each of axisNees should be, and its bounds
  Proportion inside;   ///< truths in the 95 % ellipsoid; unusable samples count as outside
  Proportion inside50; ///< the same for the 50 % ellipsoid
};

/// The bounds are the two-sided chi-square bounds of the mean at `level`. They take the errors for
/// independent: use one sample per run, or take them as a guide. Means are NaN and bounds unlimited
/// without usable samples.
Consistency consistency(std::span<const StateError> errors, double level = 0.95);

/// error^T covariance^-1 error; NaN if the sample is unusable.
double normalizedErrorSquared(const StateError& sample);

} // namespace dewpoint::experiment
