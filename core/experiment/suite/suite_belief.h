// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_summary.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Metric for the quality of a method's reported confidence.
struct BeliefMetric {
  const char* name;        ///< name in files, for example "coverage95_percent"
  const char* headerHtml;  ///< column header in a table, as HTML
  const char* description; ///< description of the metric, in one sentence
  /// Computes the value for the runs of one method in one scenario. Returns NaN if the runs do not
  /// contain the required data.
  double (*compute)(std::span<const SuiteResult* const> runs);
  /// True if small values of the metric are good, so that the worst scenario is the one with the
  /// largest value; false if large values are good.
  bool lessIsBetter;
};

/// Returns all belief metrics (metrics for the quality of the reported confidence) in table order.
std::span<const BeliefMetric> beliefMetrics();
/// Returns the belief metric (for the quality of the reported confidence) with this name, which
/// must exist.
const BeliefMetric& beliefMetric(const std::string& name);

/// Summary of a metric that has one value per scenario: the median and the worst value.
struct ScenarioSummary {
  double medianValue = 0.0; ///< median of the values; NaN if there are none
  double worstValue = 0.0;
  std::string worstScenario; ///< scenario with the worst value (the first if several have it);
                             ///< empty if there is no value
};

/// Value of a metric in one scenario.
struct ScenarioValue {
  std::string scenario;
  double value = 0.0; ///< value of the metric; NaN (no value) is ignored
};
/// Computes the median and the worst of values per scenario. NaN values are ignored.
ScenarioSummary summarizeScenarios(std::span<const ScenarioValue> values, bool lessIsBetter);

/// Belief metrics of a method over all scenarios of one grade (level of realism).
struct BeliefSummary {
  Grade grade = Grade::Ideal;
  std::string method;
  std::size_t scenarioCount = 0;
  std::size_t runCount = 0;
  std::vector<ScenarioSummary>
      metricSummaries; ///< one entry per metric, in the order of beliefMetrics()
};

/// Returns one summary for each grade and method in the cells. Grades are in ascending order, and
/// methods are in cell order.
std::vector<BeliefSummary> summarizeBelief(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
