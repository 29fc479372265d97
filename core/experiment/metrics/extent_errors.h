// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// Largest distance, as a fraction of the half extent, at which an estimate is near a target's
/// centroid. It is above 0 and at most 1, chosen by judgment. A quarter is 9 mm for the suite's
/// usual ball and about 5 cm for a stick of 30 cm.
inline constexpr double kNearFraction = 0.25;

/// Position error, estimated and true size, in one frame in which the target can be seen. Meters.
struct ExtentSample {
  std::optional<double> distance; ///< from estimate to centroid; nothing: not declared present
  double halfExtent = 0.0;        ///< longest semi-axis (TargetExtent::halfAxes)
  double radius = 0.0;            ///< radius of a ball of the same volume
  std::optional<double> estimatedRadius; ///< nothing: the method does not estimate the size
};

/// Errors relative to the target size. An error of 30 mm is large for a marble and small for a
/// shirt.
struct ExtentErrors {
  /// Samples with an estimate within kNearFraction of the half extent. The total includes samples
  /// in which the target is not declared present.
  Proportion near;
  double centroid = 0.0; ///< median of distance / halfExtent; NaN without a finite value
  double size = 0.0;     ///< median of |estimatedRadius - radius| / radius; NaN without values
};

/// Computes the errors. A sample without a positive size is excluded from values that need the
/// size, and does not count as near.
ExtentErrors extentErrors(std::span<const ExtentSample> samples);

} // namespace dewpoint::experiment
