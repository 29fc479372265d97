// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::experiment {

/// Value with its confidence interval. All fields are NaN if there was nothing to measure.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Number of cases out of a total.
struct Proportion {
  std::int64_t count = 0;
  std::int64_t total = 0;

  double value() const; ///< returns count / total, in [0, 1]; NaN if `total` is 0
};

/// Returns the proportion with its confidence interval at confidence `level`, for independent
/// trials (score interval; Wilson 1927). The interval is [0, 1] if there are no trials.
Interval wilsonInterval(const Proportion& proportion, double level = 0.95);

} // namespace dewpoint::experiment
