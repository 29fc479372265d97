// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// An estimate is near the centroid of a target within this share of its half extent. Above 0, at
/// most 1: a judgment; a quarter is 9 mm for the suite's usual ball and 5 cm for a stick of 30 cm.
inline constexpr double kNearShare = 0.25;

/// One target at one frame in which it can be seen: how far off its estimate is, and how large the
/// target truly is. Meters.
struct ExtentSample {
  std::optional<double> distance;        ///< estimate to centroid; nothing: not declared present
  double halfExtent = 0.0;               ///< its longest semi-axis (TargetExtent::halfAxes)
  double radius = 0.0;                   ///< of a ball of its volume
  std::optional<double> estimatedRadius; ///< nothing: the method does not estimate the size
};

/// Errors relative to the size of the target: 30 mm are much for a marble and little for a shirt.
struct ExtentErrors {
  /// Samples with an estimate within kNearShare of the half extent; the total is the number of all
  /// samples, also of those in which the target is not declared.
  Proportion near;
  double centroid = 0.0; ///< median of distance / halfExtent; NaN without a finite one
  double size = 0.0;     ///< median of |estimatedRadius - radius| / radius; NaN without one
};

/// Samples without a positive size are left out of the figure that needs it, and are not near.
ExtentErrors extentErrors(std::span<const ExtentSample> samples);

} // namespace dewpoint::experiment
