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

/// Placeholder for a value that does not apply.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Runs of one method in one scenario and grade: one cell of the report's tables.
struct SuiteCell {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::vector<const SuiteResult*> runs;

  Interval rmseMm; ///< median RMSE of the runs, with its 95 % bootstrap interval
  Interval p95Mm; ///< 95th percentile over all frames of all runs after convergence; whole runs are
                  ///< resampled
  Proportion quick;     ///< runs that converged within kQuickFrames
  Proportion converged; ///< runs that converged
};

/// Groups the results into cells, in key order. `results` must outlive the cells.
std::vector<SuiteCell> summarizeSuite(const SuiteResults& results,
                                      const std::vector<RunKey>& order);

/// Returns the values of a column over the runs, in ascending order. Empty values are left out, and
/// infinite values come last.
std::vector<double> columnValues(std::span<const SuiteResult* const> runs,
                                 SuiteRow::Value SuiteRow::*figure);
/// Returns the quantile or mean of columnValues(). NaN if there are no values. A quantile next to
/// an infinite value is infinite.
double quantileOf(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*figure,
                  double fraction);
double meanOf(std::span<const SuiteResult* const> runs, SuiteRow::Value SuiteRow::*figure);

/// Returns the errors of each target in each run, from its convergence on (from the start if it
/// never converged), millimeters.
std::vector<std::vector<double>> errorsAfterConvergence(std::span<const SuiteResult* const> runs);

/// Combines the reliability tables of the runs.
Reliability pooledReliability(std::span<const SuiteResult* const> runs);

} // namespace dewpoint::experiment
