// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// Reported probability of an event, and its outcome.
struct Forecast {
  double probability = 0.0; ///< reported probability, for example P(exists)
  bool hasHappened = false; ///< outcome, for example that the target was present
};

/// Row of the reliability table, for forecasts whose probability is in [low, high). The last row
/// includes `high`.
struct ReliabilityBin {
  double low = 0.0;
  double high = 0.0;
  std::int64_t forecastCount = 0;
  double meanProbability = 0.0;   ///< mean of the reported probabilities; NaN if the bin is empty
  double observedFrequency = 0.0; ///< fraction of positive outcomes; NaN if the bin is empty
};

/// Agreement of reported probabilities with outcomes.
struct Reliability {
  std::vector<ReliabilityBin> bins;
  /// Expected calibration error (Naeini, Cooper & Hauskrecht 2015): sum over the bins of
  /// forecastCount / total * |observedFrequency - meanProbability|. NaN without usable forecasts.
  double expectedCalibrationError = 0.0;
  double maxCalibrationError = 0.0; ///< largest difference |observedFrequency - meanProbability|
  double brierScore = 0.0;          ///< mean of (probability - outcome)² (Brier 1950)
  std::int64_t forecastCount = 0;   ///< number of usable forecasts
  std::int64_t unusableForecastCount =
      0; ///< number of forecasts whose probability is not in [0, 1]
};

/// Computes how well reported probabilities agree with outcomes, in `binCount` bins of equal width.
/// `binCount` must be at least 1.
Reliability computeReliability(std::span<const Forecast> forecasts, int binCount = 10);

} // namespace dewpoint::experiment
