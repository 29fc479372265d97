// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/belief_region.h"
#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace dewpoint::experiment {

/// Position error and the covariance that the method reported for it. World frame; error in m,
/// covariance in m².
struct StateError {
  Eigen::Vector3d error = Eigen::Vector3d::Zero(); ///< estimate minus truth
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// The 50 % counterpart of kChiSquared95ThreeDof. Half of the errors of a consistent estimate are
/// within this bound.
inline constexpr double kChiSquared50ThreeDof = 2.365973884375;

/// Agreement of the reported covariances with the errors. NEES is the normalized estimation error
/// squared, error^T covariance^-1 error (Bar-Shalom, Li & Kirubarajan 2001, section 5.4.2). Its
/// mean is 3 for a consistent estimate, and higher for an overconfident one.
struct Consistency {
  std::int64_t samples = 0; ///< number of all samples
  std::int64_t unusable =
      0;         ///< samples that are not finite, or whose covariance is not positive definite
  Interval nees; ///< mean NEES, with the bounds for a consistent filter (see below)
  Eigen::Vector3d axisNees = Eigen::Vector3d::Zero(); ///< mean error² / variance per world axis
  Interval axisBounds; ///< expected value (1) of each element of axisNees, with its bounds
  Proportion inside;   ///< truths in the 95 % ellipsoid; unusable samples count as outside
  Proportion inside50; ///< truths in the 50 % ellipsoid
};

/// Computes the consistency. The bounds are the two-sided chi-square bounds of the mean at `level`.
/// They assume independent errors: use one sample per run, or treat them as a guide. Without usable
/// samples, means are NaN and bounds are infinite.
Consistency consistency(std::span<const StateError> errors, double level = 0.95);

/// Returns the NEES of a sample, error^T covariance^-1 error. NaN if the sample is unusable.
double normalizedErrorSquared(const StateError& sample);

} // namespace dewpoint::experiment
