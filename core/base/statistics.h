// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <span>
#include <vector>

namespace dewpoint::base {

/// Returns the upper median of the values. No value may be NaN. For an even count, this is the
/// larger of the two central values, so the result is always one of the values. Returns 0 if there
/// are no values.
double upperMedian(std::vector<double> values);

/// Returns the same as upperMedian(), but reorders `values` instead of copying them.
double upperMedianInPlace(std::span<double> values);

/// Returns the median of the values. For an even count, this is the mean of the two central values.
/// Returns 0 if there are no values.
double median(std::vector<double> values);

/// Returns the quantile `fraction` (0 to 1) of values, interpolated linearly between neighboring
/// values. `sorted` contains the values in ascending order; there must be at least one.
double quantile(const std::vector<double>& sorted, double fraction);

/// Returns the value that the absolute value of Student's t exceeds with a probability of 5 %
/// (Cornish-Fisher expansion; Abramowitz & Stegun 26.7.5). `freedoms`: degrees of freedom, at least
/// 3. If `freedoms` is infinite, the result is 1.96, the value for the normal distribution.
double studentQuantile95(double freedoms);

} // namespace dewpoint::base
