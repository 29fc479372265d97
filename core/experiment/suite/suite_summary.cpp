// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_summary.h"

#include "core/base/statistics.h"
#include "core/experiment/metrics/bootstrap.h"
#include "core/trajectory/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Resamples of the bootstrap.
constexpr int kResamplesOfRuns = 2000;
constexpr int kResamplesOfFrames = 300; // each sorts every frame of the cell

/// Where five followed frames in a row begin, 0 if they never do.
std::size_t convergenceIteration(const std::vector<double>& errorsMm) {
  std::vector<TargetFrame> frames;
  for (std::size_t k = 0; k < errorsMm.size(); ++k) {
    TargetFrame frame;
    frame.frame = static_cast<std::int64_t>(k);
    frame.truth = Eigen::Vector3d::Zero();
    if (std::isfinite(errorsMm[k])) {
      frame.estimate = Eigen::Vector3d(1e-3 * errorsMm[k], 0.0, 0.0);
    }
    frames.push_back(frame);
  }
  return static_cast<std::size_t>(framesToConverge(frames, kFollowGate).value_or(0));
}

Interval medianOfRuns(const SuiteCell& cell) {
  std::vector<std::vector<double>> each;
  for (const double value : columnValues(cell.runs, &SuiteRow::rmseMm)) {
    each.push_back({value});
  }
  return bootstrapInterval(each, medianOf, {kResamplesOfRuns, 0.95, 1});
}

void conclude(SuiteCell& cell) {
  cell.rmseMm = medianOfRuns(cell);
  cell.p95ErrorMm =
      bootstrapInterval(errorsAfterConvergence(cell.runs), p95Of, {kResamplesOfFrames, 0.95, 1});
  for (const SuiteResult* run : cell.runs) {
    const double frames =
        run->row.framesToConverge.value_or(std::numeric_limits<double>::infinity());
    ++cell.quicklyConverged.total;
    ++cell.converged.total;
    cell.quicklyConverged.count += frames <= kQuickFrames ? 1 : 0;
    cell.converged.count += std::isfinite(frames) ? 1 : 0;
  }
}

} // namespace

std::vector<SuiteCell> summarizeSuite(const SuiteResults& results,
                                      const std::vector<RunKey>& order) {
  std::vector<SuiteCell> cells;
  for (const RunKey& key : order) {
    if (cells.empty() || cells.back().scenario != key.scenario || cells.back().grade != key.grade ||
        cells.back().method != key.method) {
      cells.push_back({key.scenario, key.grade, key.method, {}, {}, {}, {}, {}});
    }
    cells.back().runs.push_back(&results.at(key));
  }
  for (SuiteCell& cell : cells) {
    conclude(cell);
  }
  return cells;
}

std::vector<double> columnValues(std::span<const SuiteResult* const> runs,
                                 SuiteRow::Value SuiteRow::*column) {
  std::vector<double> values;
  for (const SuiteResult* run : runs) {
    const auto& value = run->row.*column;
    if (value && !std::isnan(*value)) {
      values.push_back(*value);
    }
  }
  std::ranges::sort(values);
  return values;
}

double columnQuantile(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*column,
                      double fraction) {
  const auto values = columnValues(runs, column);
  if (values.empty()) {
    return kNoValue;
  }
  const double value = quantile(values, fraction);
  return std::isnan(value) ? values.back() : value; // between two infinite ones
}

double meanOf(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*column) {
  const auto values = columnValues(runs, column);
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return values.empty() ? kNoValue : sum / static_cast<double>(values.size());
}

std::vector<std::vector<double>> errorsAfterConvergence(std::span<const SuiteResult* const> runs) {
  std::vector<std::vector<double>> all;
  for (const SuiteResult* run : runs) {
    auto& errors = all.emplace_back();
    for (const auto& target : run->trace.errorsMm) {
      for (std::size_t k = convergenceIteration(target); k < target.size(); ++k) {
        if (std::isfinite(target[k])) {
          errors.push_back(target[k]);
        }
      }
    }
  }
  return all;
}

Reliability pooledReliability(std::span<const SuiteResult* const> runs) {
  std::vector<ReliabilityCount> sums(kReliabilityBins);
  Reliability pooled;
  for (const SuiteResult* run : runs) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const ReliabilityCount& bin = run->trace.reliabilityCounts[k];
      sums[k].count += bin.count;
      sums[k].probabilitySum += bin.probabilitySum;
      sums[k].hitCount += bin.hitCount;
      pooled.forecastCount += bin.count;
    }
  }
  pooled.expectedCalibrationError = pooled.forecastCount > 0 ? 0.0 : kNoValue;
  pooled.brierScore = kNoValue; // needs each forecast
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const auto count = static_cast<double>(sums[k].count);
    const ReliabilityBin bin{static_cast<double>(k) / kReliabilityBins,
                             static_cast<double>(k + 1) / kReliabilityBins, sums[k].count,
                             sums[k].probabilitySum / count,
                             static_cast<double>(sums[k].hitCount) / count};
    pooled.bins.push_back(bin);
    if (bin.forecastCount > 0) {
      const double gap = std::abs(bin.observedFrequency - bin.meanProbability);
      pooled.expectedCalibrationError += count / static_cast<double>(pooled.forecastCount) * gap;
      pooled.maxCalibrationError = std::max(pooled.maxCalibrationError, gap);
    }
  }
  return pooled;
}

} // namespace dewpoint::experiment
