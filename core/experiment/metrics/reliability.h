// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// A stated probability and what came of it.
struct Forecast {
  double probability = 0.0; ///< such as P(exists)
  bool happened = false;    ///< such as: the target was there
};

/// One row of the reliability table: forecasts in [low, high), in the last row up to high.
struct ReliabilityBin {
  double low = 0.0;
  double high = 0.0;
  std::int64_t count = 0;
  double meanProbability = 0.0; ///< NaN if the bin is empty
  double frequency = 0.0;       ///< share that happened; NaN if the bin is empty
};

struct Reliability {
  std::vector<ReliabilityBin> bins;
  /// Expected calibration error (Naeini, Cooper & Hauskrecht 2015): sum over the bins of
  /// count / total * |frequency - meanProbability|; NaN without usable forecasts.
  double expectedError = 0.0;
  double greatestError = 0.0; ///< the largest of these differences
  double brier = 0.0;         ///< mean of (probability - outcome)² (Brier 1950)
  std::int64_t count = 0;     ///< usable forecasts
  std::int64_t unusable = 0;  ///< probability not in [0, 1]
};

/// Bins of equal width; `binCount` at least 1.
Reliability reliability(std::span<const Forecast> forecasts, int binCount = 10);

} // namespace dewpoint::experiment
