// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/reliability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr double kNoForecast = std::numeric_limits<double>::quiet_NaN();

std::vector<ReliabilityBin> emptyBins(int binCount) {
  std::vector<ReliabilityBin> bins(static_cast<std::size_t>(binCount));
  for (int k = 0; k < binCount; ++k) {
    bins[static_cast<std::size_t>(k)].low = static_cast<double>(k) / binCount;
    bins[static_cast<std::size_t>(k)].high = static_cast<double>(k + 1) / binCount;
  }
  return bins;
}

void addForecasts(std::span<const Forecast> forecasts, Reliability& result) {
  for (const Forecast& forecast : forecasts) {
    const double probability = forecast.probability;
    if (!(probability >= 0.0 && probability <= 1.0)) {
      ++result.unusable;
      continue;
    }
    const auto slot =
        static_cast<std::size_t>(probability * static_cast<double>(result.bins.size()));
    ReliabilityBin& bin = result.bins[std::min(slot, result.bins.size() - 1)];
    const double outcome = forecast.happened ? 1.0 : 0.0;
    ++bin.count;
    ++result.count;
    bin.meanProbability += probability;
    bin.frequency += outcome;
    result.brier += (probability - outcome) * (probability - outcome);
  }
}

} // namespace

Reliability reliability(std::span<const Forecast> forecasts, int binCount) {
  Reliability result;
  result.bins = emptyBins(binCount);
  addForecasts(forecasts, result);
  const auto total = static_cast<double>(result.count);
  for (ReliabilityBin& bin : result.bins) {
    const auto count = static_cast<double>(bin.count);
    bin.meanProbability = bin.count == 0 ? kNoForecast : bin.meanProbability / count;
    bin.frequency = bin.count == 0 ? kNoForecast : bin.frequency / count;
    if (bin.count == 0)
      continue;
    const double difference = std::abs(bin.frequency - bin.meanProbability);
    result.expectedError += count / total * difference;
    result.maxError = std::max(result.maxError, difference);
  }
  result.brier /= total;
  if (result.count == 0)
    result.expectedError = result.maxError = result.brier = kNoForecast;
  return result;
}

} // namespace dewpoint::experiment
