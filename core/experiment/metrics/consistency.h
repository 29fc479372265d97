// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/belief_region.h"
#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// Error of an estimated position, and the covariance that the method reported for that position.
/// World frame; error in m, covariance in m².
struct StateError {
  Eigen::Vector3d error = Eigen::Vector3d::Zero(); ///< estimate minus truth
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// 50 % quantile of the chi-square distribution with three degrees of freedom. The NEES (normalized
/// estimation error squared) of a consistent 3D estimate is below this bound in half of the cases.
inline constexpr double kChiSquared50ThreeDof = 2.365973884375;

/// Agreement of the reported covariances with the errors. NEES is the normalized estimation error
/// squared, error^T covariance^-1 error (Bar-Shalom, Li & Kirubarajan 2001, section 5.4.2). Its
/// mean is 3 for a consistent estimate, and higher for an overconfident one.
struct Consistency {
  std::int64_t sampleCount = 0; ///< number of all samples
  std::int64_t unusableSampleCount =
      0; ///< number of samples that are not finite, or whose covariance is not positive definite
  Interval nees; ///< mean NEES, with the bounds for a consistent filter, see computeConsistency()
  /// Mean of error² / reported variance for each world axis; 1 is expected.
  Eigen::Vector3d axisNees = Eigen::Vector3d::Zero();
  /// Expected value of each element of axisNees (1), with the bounds for a consistent filter.
  Interval axisNeesBounds;
  Proportion coverage95; ///< truths in the 95 % ellipsoid; unusable samples count as outside
  Proportion coverage50; ///< truths in the 50 % ellipsoid
};

/// Computes how well the reported covariances agree with the errors. The bounds are the two-sided
/// chi-square bounds of the mean at confidence `level`. They are valid for independent errors only:
/// pass one sample per run, or treat the bounds as a rough guide. Without usable samples, means are
/// NaN and bounds are infinite.
Consistency computeConsistency(std::span<const StateError> errors, double level = 0.95);

/// Returns the NEES (normalized estimation error squared) of a sample: error^T covariance^-1 error.
/// Returns NaN if the error is not finite or the covariance is not positive definite.
double normalizedErrorSquared(const StateError& sample);

} // namespace dewpoint::experiment
