// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <span>
#include <vector>

namespace dewpoint::base {

/// The upper median: the middle one of the sorted values, of an even number the upper of the two.
/// Always one of the values, which must not be NaN; 0 of none.
double upperMedian(std::vector<double> values);

/// The same in place, without a copy: `values` are reordered.
double upperMedianInPlace(std::span<double> values);

/// The median: of an even number the mean of the two values in the middle; 0 of none.
double median(std::vector<double> values);

/// Quantile of ascending values (at least one), linear between order statistics; `fraction` in
/// [0, 1].
double quantile(const std::vector<double>& sorted, double fraction);

} // namespace dewpoint::base
