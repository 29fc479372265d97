// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"
#include "core/experiment/metrics/reliability.h"
#include "core/experiment/suite/suite_store.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Value of a metric that does not apply.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Runs of one method in one scenario and grade: one cell of the report's tables.
struct SuiteCell {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::vector<const SuiteResult*> runs;

  Interval rmseMm; ///< median RMSE of the runs, with its 95 % bootstrap interval
  /// 95th percentile of the errors after convergence, over all frames of all runs, with its
  /// bootstrap interval. Whole runs are resampled for this interval.
  Interval p95ErrorMm;
  Proportion quicklyConverged; ///< fraction of the runs that converged within kQuickFrames frames
  Proportion converged;        ///< fraction of the runs that converged
};

/// Groups the runs with the keys `order` into cells (scenario, grade and method), in this order.
/// `results` must outlive the cells.
std::vector<SuiteCell> summarizeSuite(const SuiteResults& results,
                                      const std::vector<RunKey>& order);

/// Returns the values of a column of runs.csv over the runs, in ascending order. Empty values are
/// left out, and infinite values come last.
std::vector<double> columnValues(std::span<const SuiteResult* const> runs,
                                 SuiteRow::Value SuiteRow::*column);
/// Return a quantile (`fraction` in [0, 1]) and the mean of a column of runs.csv over the runs; NaN
/// if the column has no values. A quantile that lies between a finite and an infinite value is
/// infinite.
double columnQuantile(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*column,
                      double fraction);
double meanOf(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*column);

/// Returns the errors of each target in each run from convergence on, in millimeters. If a target
/// never converged, its errors begin with the start of the run.
std::vector<std::vector<double>> errorsAfterConvergence(std::span<const SuiteResult* const> runs);

/// Returns how well the reported P(exists) agrees with how often the estimates were on a target,
/// over all estimates of all runs.
Reliability pooledReliability(std::span<const SuiteResult* const> runs);

} // namespace dewpoint::experiment
