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
      ++result.unusableForecastCount;
      continue;
    }
    const auto slot =
        static_cast<std::size_t>(probability * static_cast<double>(result.bins.size()));
    ReliabilityBin& bin = result.bins[std::min(slot, result.bins.size() - 1)];
    const double outcome = forecast.hasHappened ? 1.0 : 0.0;
    ++bin.forecastCount;
    ++result.forecastCount;
    bin.meanProbability += probability;
    bin.observedFrequency += outcome;
    result.brierScore += (probability - outcome) * (probability - outcome);
  }
}

} // namespace

Reliability computeReliability(std::span<const Forecast> forecasts, int binCount) {
  Reliability result;
  result.bins = emptyBins(binCount);
  addForecasts(forecasts, result);
  const auto total = static_cast<double>(result.forecastCount);
  for (ReliabilityBin& bin : result.bins) {
    const auto count = static_cast<double>(bin.forecastCount);
    bin.meanProbability = bin.forecastCount == 0 ? kNoForecast : bin.meanProbability / count;
    bin.observedFrequency = bin.forecastCount == 0 ? kNoForecast : bin.observedFrequency / count;
    if (bin.forecastCount == 0)
      continue;
    const double difference = std::abs(bin.observedFrequency - bin.meanProbability);
    result.expectedCalibrationError += count / total * difference;
    result.maxCalibrationError = std::max(result.maxCalibrationError, difference);
  }
  result.brierScore /= total;
  if (result.forecastCount == 0)
    result.expectedCalibrationError = result.maxCalibrationError = result.brierScore = kNoForecast;
  return result;
}

} // namespace dewpoint::experiment
