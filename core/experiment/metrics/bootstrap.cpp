// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/bootstrap.h"

#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/trajectory/error_statistics.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dewpoint::experiment {
namespace {

struct PooledValue {
  double value = 0.0;
  std::size_t run = 0;
};

/// All values in ascending order: sorted once, so that a resample needs no sorting.
std::vector<PooledValue> pool(std::span<const std::vector<double>> runs) {
  std::vector<PooledValue> pooled;
  for (std::size_t run = 0; run < runs.size(); ++run)
    for (const double value : runs[run])
      pooled.push_back({value, run});
  std::stable_sort(pooled.begin(), pooled.end(),
                   [](const auto& a, const auto& b) { return a.value < b.value; });
  return pooled;
}

/// How often each run is drawn.
std::vector<int> drawRuns(std::size_t runCount, const RandomStream& random) {
  std::vector<int> times(runCount, 0);
  for (std::size_t draw = 0; draw < runCount; ++draw) {
    const double drawn =
        random.uniform(static_cast<std::uint32_t>(draw)) * static_cast<double>(runCount);
    ++times[std::min(static_cast<std::size_t>(drawn), runCount - 1)];
  }
  return times;
}

} // namespace

double meanOf(const std::vector<double>& sorted) {
  return std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
}

double medianOf(const std::vector<double>& sorted) {
  return quantile(sorted, 0.5);
}

double p95Of(const std::vector<double>& sorted) {
  return quantile(sorted, 0.95);
}

Interval bootstrapInterval(std::span<const std::vector<double>> runs, const Statistic& statistic,
                           const BootstrapSetup& setup) {
  const std::vector<PooledValue> pooled = pool(runs);
  if (pooled.empty()) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    return {kNothing, kNothing, kNothing};
  }
  std::vector<double> resample;
  const auto fillResample = [&](const std::vector<int>& times) {
    resample.clear();
    for (const PooledValue& entry : pooled)
      resample.insert(resample.end(), static_cast<std::size_t>(times[entry.run]), entry.value);
  };
  fillResample(std::vector<int>(runs.size(), 1));
  Interval interval{statistic(resample), 0.0, 0.0};
  std::vector<double> figures;
  for (int k = 0; k < setup.resampleCount; ++k) {
    const RandomStream random(setup.seed, static_cast<std::uint32_t>(k), 0,
                              RandomPurpose::Resampling);
    fillResample(drawRuns(runs.size(), random));
    if (!resample.empty()) // only empty runs may have been drawn
      figures.push_back(statistic(resample));
  }
  if (figures.empty())
    figures.push_back(interval.value);
  std::sort(figures.begin(), figures.end());
  interval.low = quantile(figures, (1.0 - setup.confidenceLevel) / 2.0);
  interval.high = quantile(figures, (1.0 + setup.confidenceLevel) / 2.0);
  return interval;
}

} // namespace dewpoint::experiment
