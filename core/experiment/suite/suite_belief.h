// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_summary.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// A figure by which it is judged whether a method knows how sure it may be.
struct BeliefFigure {
  const char* name;     ///< in files: "coverage95_percent"
  const char* head;     ///< of a table's column, HTML
  const char* sentence; ///< what it is
  /// Of the runs of one method in one scenario; NaN where they have none.
  double (*of)(std::span<const SuiteResult* const> runs);
  /// The worst scenario is the one with the greatest value; else the one with the least.
  bool lessIsBetter;
};

/// All of them, in the order of the tables.
std::span<const BeliefFigure> beliefFigures();
/// The one of this name (asserted).
const BeliefFigure& beliefFigure(const std::string& name);

/// One value per scenario, by which a method is judged twice: by the median, and by the worst.
struct OverScenarios {
  double median = 0.0; ///< NaN without a value
  double worst = 0.0;
  std::string worstScenario; ///< the first of equally bad ones; empty without a value
};

struct ScenarioValue {
  std::string scenario;
  double value = 0.0; ///< NaN: left out
};
OverScenarios overScenarios(std::span<const ScenarioValue> values, bool lessIsBetter);

/// A method's figures of belief over all scenarios of one grade.
struct BeliefSummary {
  Grade grade = Grade::Ideal;
  std::string method;
  std::size_t scenarios = 0;
  std::size_t runs = 0;
  std::vector<OverScenarios> figures; ///< as beliefFigures()
};

/// One for each grade and method among the cells: grades in their order, methods as they come.
std::vector<BeliefSummary> summarizeBelief(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
