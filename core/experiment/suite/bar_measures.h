// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_belief.h"

#include <functional>
#include <string>
#include <vector>

// How the value of a requirement is computed from runs. All measures are NaN if the runs have no
// such value.
namespace dewpoint::experiment {

using BarRuns = std::vector<const SuiteResult*>;

/// Value, and the scenario that determines it if it depends on one scenario alone.
struct BarFigure {
  BarFigure(double number) : value(number) {} // a plain value has no scenario
  BarFigure(double number, std::string name) : value(number), scenario(std::move(name)) {}
  double value;
  std::string scenario;
};

/// Computes the value from our runs. `others` are the runs of plain triangulation in the same
/// scenarios and the same grade.
using BarMeasure = std::function<BarFigure(const BarRuns& ours, const BarRuns& others)>;
using BarColumn = SuiteRow::Figure SuiteRow::*;

/// Quantile over the runs; `fraction` in [0, 1].
BarMeasure quantileAt(BarColumn figure, double fraction);
/// Value of the worst run.
BarMeasure worstRun(BarColumn figure);
/// Largest of the scenarios' medians over runs.
BarMeasure worstMedian(BarColumn figure);
/// Mean over all runs, times `factor`.
BarMeasure meanOfRuns(BarColumn figure, double factor = 1.0);
/// Percentage of runs whose value is at most `limit`.
BarMeasure percentWithin(BarColumn figure, double limit);
/// Number of runs in which the event never happened.
BarMeasure failures(BarColumn figure);

/// 95th percentile of all errors after convergence.
BarFigure pooledP95(const BarRuns& ours, const BarRuns& others);
/// Calibration error of P(exists), over all frames of all runs.
BarFigure pooledEceOfRuns(const BarRuns& ours, const BarRuns& others);
/// Absolute value of the mean depth bias over runs.
BarFigure depthBias(const BarRuns& ours, const BarRuns& others);
/// Ratio of the median RMSE of our runs to that of triangulation.
BarFigure againstTriangulation(const BarRuns& ours, const BarRuns& others);

/// Ratio of the RMSE of our runs to that of the others' runs of the same seed, over the frames in
/// which both declare the target: the median over the seeds. A method that gives up on difficult
/// frames therefore gains nothing.
BarFigure sharedFramesRatio(const BarRuns& ours, const BarRuns& others);
/// Percentage of lost frames minus that of the other run of the same seed: the mean.
BarFigure lostBeyondTriangulation(const BarRuns& ours, const BarRuns& others);

/// A metric of belief: the median over the scenarios.
BarMeasure medianScenario(const BeliefMetric& metric);
/// The same: of the worst scenario.
BarMeasure worstScenario(const BeliefMetric& metric);
/// The greatest value that a measure has in one scenario alone.
BarMeasure greatestOfScenarios(BarMeasure measure);

} // namespace dewpoint::experiment
