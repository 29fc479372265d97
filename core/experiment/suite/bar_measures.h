// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_belief.h"

#include <functional>
#include <string>
#include <vector>

// Measures compute the value of a requirement from runs. All measures are NaN if the runs have no
// such value.
namespace dewpoint::experiment {

/// Runs from which a measure is computed.
using MeasuredRuns = std::vector<const SuiteResult*>;

/// Value of a measure. If a single scenario determines the value, it includes that scenario.
struct RequirementValue {
  RequirementValue(double number) : value(number) {} // a plain value has no scenario
  RequirementValue(double number, std::string name) : value(number), scenario(std::move(name)) {}
  double value;
  std::string scenario;
};

/// Computes the value from our runs. `others` are the runs of plain triangulation in the same
/// scenarios and grade.
using RequirementMeasure =
    std::function<RequirementValue(const MeasuredRuns& ours, const MeasuredRuns& others)>;
/// Column of runs.csv that a measure reads.
using ResultColumn = SuiteRow::Value SuiteRow::*;

/// Returns a measure: the quantile over the runs. `fraction` is in [0, 1].
RequirementMeasure quantileOverRuns(ResultColumn figure, double fraction);
/// Returns a measure: the value of the worst run.
RequirementMeasure worstRun(ResultColumn figure);
/// Returns a measure: the largest scenario median, where each median is taken over the runs of a
/// scenario.
RequirementMeasure worstMedian(ResultColumn figure);
/// Returns a measure: the mean over all runs, times `factor`.
RequirementMeasure meanOverRuns(ResultColumn figure, double factor = 1.0);
/// Returns a measure: the percentage of runs whose value is at most `limit`.
RequirementMeasure percentWithin(ResultColumn figure, double limit);
/// Returns a measure: the number of runs in which the event never happened.
RequirementMeasure failureCount(ResultColumn figure);

/// Computes the 95th percentile of all errors after convergence.
RequirementValue pooledP95(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the calibration error of P(exists), over all frames of all runs.
RequirementValue pooledEceOfRuns(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the absolute value of the mean depth bias over runs.
RequirementValue depthBias(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the ratio of the median RMSE of our runs to the median RMSE of triangulation.
RequirementValue rmseRatioToTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others);

/// Computes the ratio of the RMSE of our run to that of the other method's run with the same seed,
/// over the frames in which both declare the target. Returns the median over the seeds. A method
/// that gives up on difficult frames therefore gains nothing.
RequirementValue rmseRatioOnSharedFrames(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the percentage of lost frames minus the percentage in the other run with the same seed.
/// Returns the mean over the seeds.
RequirementValue lostFramesOverTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others);

/// Returns a measure: the median of a belief metric over the scenarios.
RequirementMeasure medianOverScenarios(const BeliefMetric& metric);
/// Returns a measure: the value of a belief metric in the worst scenario.
RequirementMeasure worstOverScenarios(const BeliefMetric& metric);
/// Returns a measure: the largest value that another measure has when it is computed for each
/// scenario separately.
RequirementMeasure maxOverScenarios(RequirementMeasure measure);

} // namespace dewpoint::experiment
