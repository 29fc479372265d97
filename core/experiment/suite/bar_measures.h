// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_belief.h"

#include <functional>
#include <string>
#include <vector>

// Measures compute the value of a requirement from runs. The value is NaN if the runs do not
// contain what is measured.
namespace dewpoint::experiment {

/// Runs from which a measure is computed.
using MeasuredRuns = std::vector<const SuiteResult*>;

/// Value of a measure. If a single scenario determines the value, `scenario` is its name; otherwise
/// it is empty.
struct RequirementValue {
  RequirementValue(double number) : value(number) {} // a plain value has no scenario
  RequirementValue(double number, std::string name) : value(number), scenario(std::move(name)) {}
  double value;
  std::string scenario;
};

/// Computes the value of a requirement from the runs of the `dewpoint` method (`ours`). `others`
/// are the runs of plain triangulation in the same scenarios and grade.
using RequirementMeasure =
    std::function<RequirementValue(const MeasuredRuns& ours, const MeasuredRuns& others)>;
/// Column of runs.csv that a measure reads.
using ResultColumn = SuiteRow::Value SuiteRow::*;

/// Returns a measure that computes a quantile of a column over the runs. `fraction` (0 to 1)
/// selects the quantile: 0.5 is the median.
RequirementMeasure quantileOverRuns(ResultColumn column, double fraction);
/// Returns a measure that computes the largest value of a column over the runs (the value of the
/// worst run).
RequirementMeasure worstRun(ResultColumn column);
/// Returns a measure that computes the median of a column over the runs of each scenario, and then
/// the largest of these medians.
RequirementMeasure worstMedian(ResultColumn column);
/// Returns a measure that computes the mean of a column over all runs, times `factor`.
RequirementMeasure meanOverRuns(ResultColumn column, double factor = 1.0);
/// Returns a measure that computes the percentage of runs whose value in a column is at most
/// `limit`.
RequirementMeasure percentWithin(ResultColumn column, double limit);
/// Returns a measure that counts the runs in which the event that a column describes, such as
/// convergence, never happened.
RequirementMeasure failureCount(ResultColumn column);

/// Computes the 95th percentile of all position errors of our runs after convergence.
RequirementValue pooledP95(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the expected calibration error of the reported P(exists), over all frames of all our
/// runs.
RequirementValue pooledEceOfRuns(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the absolute value of the mean, over our runs, of the depth bias (the mean error along
/// the viewing direction).
RequirementValue depthBias(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the ratio of the median RMSE of our runs to the median RMSE of triangulation.
RequirementValue rmseRatioToTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others);

/// Computes the median, over all runs, of the RMSE of our run divided by the RMSE of the
/// triangulation run with the same scenario and seed. Each RMSE covers only the frames in which
/// both methods declare the target present, so a method gains nothing by giving up in difficult
/// frames.
RequirementValue rmseRatioOnSharedFrames(const MeasuredRuns& ours, const MeasuredRuns& others);
/// Computes the mean, over all runs, of the percentage of lost frames in our run minus the
/// percentage in the triangulation run with the same scenario and seed.
RequirementValue lostFramesOverTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others);

/// Returns a measure that computes the median of a belief metric over the scenarios.
RequirementMeasure medianOverScenarios(const BeliefMetric& metric);
/// Returns a measure that computes the value of a belief metric in the worst scenario.
RequirementMeasure worstOverScenarios(const BeliefMetric& metric);
/// Returns a measure that computes `measure` for each scenario separately, and then the largest of
/// these values.
RequirementMeasure maxOverScenarios(RequirementMeasure measure);

} // namespace dewpoint::experiment
