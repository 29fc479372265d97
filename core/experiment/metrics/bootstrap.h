// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// Function that computes a statistic, such as a median, of values in ascending order. There is at
/// least one value.
using Statistic = std::function<double(const std::vector<double>& sorted)>;

double meanOf(const std::vector<double>& sorted);
double medianOf(const std::vector<double>& sorted);
/// Returns the 95th percentile, interpolated linearly between order statistics.
double p95Of(const std::vector<double>& sorted);

/// Number of resamples, confidence level and seed of a bootstrap.
struct BootstrapSetup {
  int resampleCount = 2000;
  double confidenceLevel = 0.95;
  std::uint64_t seed = 1;
};

/// Returns a statistic of the values of all runs together, with its percentile bootstrap interval
/// (Efron & Tibshirani 1993, chapter 13). Whole runs are drawn with replacement, because values
/// within a run depend on each other (cluster bootstrap; Davison & Hinkley 1997, section 3.8). If
/// the values are independent, pass each value as a separate run. Values must be finite; runs may
/// be empty. Returns NaN if there are no values. The result is deterministic for a given seed.
Interval bootstrapInterval(std::span<const std::vector<double>> runs, const Statistic& statistic,
                           const BootstrapSetup& setup = {});

} // namespace dewpoint::experiment
