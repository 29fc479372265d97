// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_belief.h"

#include <functional>
#include <string>
#include <vector>

// How the figure of a requirement is taken from runs. All measures are NaN where the runs have no
// such figure.
namespace dewpoint::experiment {

using BarRuns = std::vector<const SuiteResult*>;

/// A figure, and the scenario that decides it where it is one scenario's alone.
struct BarFigure {
  BarFigure(double number) : value(number) {} // a plain figure is one of no scenario
  BarFigure(double number, std::string name) : value(number), scenario(std::move(name)) {}
  double value;
  std::string scenario;
};

/// The figure of our runs; `others` are those of plain triangulation in the same scenarios and the
/// same grade.
using BarMeasure = std::function<BarFigure(const BarRuns& ours, const BarRuns& others)>;
using BarColumn = SuiteRow::Figure SuiteRow::*;

BarMeasure quantileAt(BarColumn figure, double fraction);
/// Of the worst run.
BarMeasure worstRun(BarColumn figure);
/// The largest of the scenarios' medians over runs.
BarMeasure worstMedian(BarColumn figure);
/// The mean over all runs, times `factor`.
BarMeasure meanOfRuns(BarColumn figure, double factor = 1.0);
/// Percent of runs whose figure is at most `limit`.
BarMeasure percentWithin(BarColumn figure, double limit);
/// Number of runs in which it never happened.
BarMeasure failures(BarColumn figure);

/// Of all errors after convergence.
BarFigure pooledP95(const BarRuns& ours, const BarRuns& others);
/// Calibration error of P(exists), of all frames of all runs.
BarFigure pooledEceOfRuns(const BarRuns& ours, const BarRuns& others);
/// The absolute mean over runs.
BarFigure depthBias(const BarRuns& ours, const BarRuns& others);
/// Ratio of the medians of the RMSE.
BarFigure againstTriangulation(const BarRuns& ours, const BarRuns& others);

/// Ratio of the RMSE of our runs and the others' runs of the same seed, over the frames in which
/// both declare the target: the median over the seeds. In this way a method that gives up the hard
/// frames has nothing from it.
BarFigure sharedFramesRatio(const BarRuns& ours, const BarRuns& others);
/// Percentage of lost frames minus that of the other run of the same seed: the mean.
BarFigure lostBeyondTriangulation(const BarRuns& ours, const BarRuns& others);

/// A figure of belief: the median over the scenarios.
BarMeasure medianScenario(const BeliefFigure& figure);
/// The same: of the worst scenario.
BarMeasure worstScenario(const BeliefFigure& figure);
/// The greatest value that a measure has in one scenario alone.
BarMeasure greatestOfScenarios(BarMeasure measure);

} // namespace dewpoint::experiment
