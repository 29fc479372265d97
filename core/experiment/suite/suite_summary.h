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

/// Marks a value that does not apply.
inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

/// Runs of one method in one scenario and grade: one cell of the report's tables.
struct SuiteCell {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::vector<const SuiteResult*> runs;

  Interval rmseMm;      ///< median over the runs' RMSE, bootstrap 95 % interval
  Interval p95Mm;       ///< over all frames of all runs after convergence; whole runs are resampled
  Proportion quick;     ///< runs that converged within kQuickFrames
  Proportion converged; ///< runs that converged at all
};

/// Cells in the order of the keys. `results` must outlive them.
std::vector<SuiteCell> summarizeSuite(const SuiteResults& results,
                                      const std::vector<RunKey>& order);

/// Values of a column over the runs in ascending order, without empty ones. Infinite values come
/// last.
std::vector<double> figuresOf(std::span<const SuiteResult* const> runs,
                              SuiteRow::Figure SuiteRow::*figure);
/// Quantile and mean of figuresOf(); NaN if there are no values. A quantile next to an infinite
/// value is infinite.
double quantileOf(std::span<const SuiteResult* const> runs, SuiteRow::Figure SuiteRow::*figure,
                  double fraction);
double meanOf(std::span<const SuiteResult* const> runs, SuiteRow::Figure SuiteRow::*figure);

/// Errors of each target of each run from its convergence on (from the start if it never
/// converged), millimeters.
std::vector<std::vector<double>> errorsAfterConvergence(std::span<const SuiteResult* const> runs);

/// Combines the reliability tables of the runs.
Reliability pooledReliability(std::span<const SuiteResult* const> runs);

} // namespace dewpoint::experiment
