// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_summary.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// A metric by which it is assessed whether a method knows how sure it may be.
struct BeliefMetric {
  const char* name;     ///< in files: "coverage95_percent"
  const char* head;     ///< of a table's column, HTML
  const char* sentence; ///< what it is
  /// Of the runs of one method in one scenario; NaN where they have none.
  double (*of)(std::span<const SuiteResult* const> runs);
  /// Whether the worst scenario is the one with the largest value; otherwise it is the one with the
  /// smallest.
  bool lessIsBetter;
};

/// All of them, in the order of the tables.
std::span<const BeliefMetric> beliefMetrics();
/// The one of this name (asserted).
const BeliefMetric& beliefMetric(const std::string& name);

/// One value per scenario, summarized by the median and by the worst.
struct OverScenarios {
  double median = 0.0; ///< NaN without a value
  double worst = 0.0;
  std::string worstScenario; ///< first of ties; empty without a value
};

/// Value of a metric in one scenario.
struct ScenarioValue {
  std::string scenario;
  double value = 0.0; ///< NaN: ignored
};
/// Computes the median and the worst of the values.
OverScenarios overScenarios(std::span<const ScenarioValue> values, bool lessIsBetter);

/// Metrics of belief of a method over all scenarios of one grade.
struct BeliefSummary {
  Grade grade = Grade::Ideal;
  std::string method;
  std::size_t scenarios = 0;
  std::size_t runs = 0;
  std::vector<OverScenarios> figures; ///< as beliefMetrics()
};

/// Summaries, one per grade and method among the cells: grades in their order, methods in the order
/// of the cells.
std::vector<BeliefSummary> summarizeBelief(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
