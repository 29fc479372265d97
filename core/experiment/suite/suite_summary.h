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

/// Stands where a figure makes no sense.
inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

/// The runs of one method in one scenario and grade: one cell of the report's tables.
struct SuiteCell {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::vector<const SuiteResult*> runs;

  Interval rmseMm;      ///< median over the runs' RMSE, bootstrap 95 % interval
  Interval p95Mm;       ///< of all frames of all runs after convergence; whole runs are resampled
  Proportion quick;     ///< runs converged within kQuickFrames
  Proportion converged; ///< runs converged at all
};

/// The cells in the order of the keys. `results` outlives them.
std::vector<SuiteCell> summarizeSuite(const SuiteResults& results,
                                      const std::vector<RunKey>& order);

/// The runs' figures in ascending order, without those that have none. Infinite ones stand last.
std::vector<double> figuresOf(std::span<const SuiteResult* const> runs,
                              SuiteRow::Figure SuiteRow::*figure);
/// Quantile and mean of figuresOf(); NaN if there is none. A quantile next to an infinite figure is
/// infinite.
double quantileOf(std::span<const SuiteResult* const> runs, SuiteRow::Figure SuiteRow::*figure,
                  double fraction);
double meanOf(std::span<const SuiteResult* const> runs, SuiteRow::Figure SuiteRow::*figure);

/// Errors of each target of each run from its convergence on (from the start if it never did),
/// millimeters.
std::vector<std::vector<double>> errorsAfterConvergence(std::span<const SuiteResult* const> runs);

/// The runs' reliability tables as one.
Reliability pooledReliability(std::span<const SuiteResult* const> runs);

} // namespace dewpoint::experiment
