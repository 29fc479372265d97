// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <span>
#include <vector>

namespace dewpoint::base {

/// Upper median of the values, which must not be NaN: for an even count, the upper of the two
/// central values, so that the result is always one of the values. 0 when there are none.
double upperMedian(std::vector<double> values);

/// Upper median without a copy: reorders `values`.
double upperMedianInPlace(std::span<double> values);

/// Median of the values: for an even count, the mean of the two central values. 0 when there are
/// none.
double median(std::vector<double> values);

/// Quantile of ascending values (at least one), linearly interpolated between order statistics;
/// `fraction` is in [0, 1].
double quantile(const std::vector<double>& sorted, double fraction);

} // namespace dewpoint::base
