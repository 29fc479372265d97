// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// Largest distance between an estimate and the target's centroid at which the estimate counts as
/// near, as a fraction of the target's half extent (its longest semi-axis). Chosen by judgment: 9
/// mm for the suite's usual ball, and about 5 cm for a stick of 30 cm.
inline constexpr double kNearFraction = 0.25;

/// Position error, true size and estimated size of a target in one frame in which the target can be
/// seen. Meters.
struct ExtentSample {
  /// Distance from the estimate to the centroid of the target. Empty: the method does not declare
  /// the target present.
  std::optional<double> centroidDistance;
  /// Longest semi-axis of the target (TargetExtent::halfAxes).
  double halfExtent = 0.0;
  double radius = 0.0; ///< radius of a ball with the same volume as the target
  /// Estimated `radius`; empty: the method does not estimate the size.
  std::optional<double> estimatedRadius;
};

/// Errors relative to the target size. An error of 30 mm is large for a marble and small for a
/// shirt.
struct ExtentErrors {
  /// Number of samples with an estimate whose distance is at most kNearFraction of the half extent.
  /// The total includes samples in which the target is not declared present.
  Proportion nearEstimateProportion;
  double relativeCentroidError =
      0.0; ///< median of centroidDistance / halfExtent; NaN without a finite value
  double relativeSizeError =
      0.0; ///< median of |estimatedRadius - radius| / radius; NaN without values
};

/// Computes the errors relative to the target size. A sample whose true size is not positive counts
/// as not near in ExtentErrors::nearEstimateProportion, and does not contribute to `centroid` and
/// `size`.
ExtentErrors measureExtentErrors(std::span<const ExtentSample> samples);

} // namespace dewpoint::experiment
