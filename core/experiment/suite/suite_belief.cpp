// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_belief.h"

#include "core/base/statistics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

using RunSpan = std::span<const SuiteResult* const>;

template <SuiteRow::Value SuiteRow::*Member> double meanFigure(RunSpan runs) {
  return meanOf(runs, Member);
}

double medianNees(RunSpan runs) {
  return columnQuantile(runs, &SuiteRow::nees, 0.5);
}

double pooledEce(RunSpan runs) {
  return pooledReliability(runs).expectedCalibrationError;
}

BeliefSummary summaryOf(std::span<const SuiteCell* const> cells) {
  BeliefSummary summary{cells.front()->grade, cells.front()->method, cells.size(), 0, {}};
  for (const SuiteCell* cell : cells) {
    summary.runCount += cell->runs.size();
  }
  for (const BeliefMetric& metric : beliefMetrics()) {
    std::vector<ScenarioValue> values;
    values.reserve(cells.size());
    for (const SuiteCell* cell : cells) {
      values.push_back({cell->scenario, metric.compute(cell->runs)});
    }
    summary.metricSummaries.push_back(summarizeScenarios(values, metric.lessIsBetter));
  }
  return summary;
}

} // namespace

std::span<const BeliefMetric> beliefMetrics() {
  static constexpr std::array kFigures{
      BeliefMetric{"coverage50_percent", "in 50 %<br>ellipsoid %",
                   "truths inside the stated 50 % ellipsoid, mean over the runs",
                   meanFigure<&SuiteRow::coverage50Percent>, false},
      BeliefMetric{"coverage95_percent", "in 95 %<br>ellipsoid %",
                   "truths inside the stated 95 % ellipsoid, mean over the runs",
                   meanFigure<&SuiteRow::coverage95Percent>, false},
      BeliefMetric{"nees", "NEES",
                   "normalized estimation error squared, median over the runs; 3 is consistent",
                   medianNees, true},
      BeliefMetric{"existence_ece", "ECE of<br>P(exists)",
                   "expected calibration error of P(exists), of all frames of all runs", pooledEce,
                   true},
      BeliefMetric{"sure_and_wrong_percent", "sure and<br>wrong %",
                   "frames with P(exists) above 0.95 and the target absent or farther off than "
                   "three stated radii, mean over the runs",
                   meanFigure<&SuiteRow::confidentlyWrongPercent>, true},
      BeliefMetric{"wrong_percent", "declared, not<br>within 30 mm %",
                   "frames with the target declared, but absent or not within 30 mm, mean over the "
                   "runs",
                   meanFigure<&SuiteRow::wrongPercent>, true},
      BeliefMetric{"wrong_when_sure_percent", "the same with<br>P &gt; 0.95 %",
                   "the same with P(exists) above 0.95",
                   meanFigure<&SuiteRow::wrongWhenConfidentPercent>, true},
      BeliefMetric{"sure_of_tie_percent", "sure of<br>a tie %",
                   "where N objects are the target equally well: frames with the target declared "
                   "and P(exists) above 1 / N + 0.05, mean over the runs",
                   meanFigure<&SuiteRow::confidentInTiePercent>, true},
  };
  return kFigures;
}

const BeliefMetric& beliefMetric(const std::string& name) {
  const auto all = beliefMetrics();
  const auto found =
      std::ranges::find_if(all, [&](const BeliefMetric& metric) { return name == metric.name; });
  assert(found != all.end());
  return *found;
}

ScenarioSummary summarizeScenarios(std::span<const ScenarioValue> values, bool lessIsBetter) {
  std::vector<double> usable;
  const ScenarioValue* worst = nullptr;
  for (const ScenarioValue& value : values) {
    if (std::isnan(value.value)) {
      continue;
    }
    usable.push_back(value.value);
    const bool worse = worst == nullptr ||
                       (lessIsBetter ? value.value > worst->value : value.value < worst->value);
    worst = worse ? &value : worst;
  }
  if (worst == nullptr) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    return {kNothing, kNothing, {}};
  }
  return {median(std::move(usable)), worst->value, worst->scenario};
}

std::vector<BeliefSummary> summarizeBelief(std::span<const SuiteCell> cells) {
  std::vector<std::vector<const SuiteCell*>> groups;
  for (const SuiteCell& cell : cells) {
    const auto same = std::ranges::find_if(groups, [&](const auto& group) {
      return group.front()->grade == cell.grade && group.front()->method == cell.method;
    });
    if (same == groups.end()) {
      groups.push_back({&cell});
    } else {
      same->push_back(&cell);
    }
  }
  std::ranges::stable_sort(groups, {}, [](const auto& group) { return group.front()->grade; });
  std::vector<BeliefSummary> summaries;
  summaries.reserve(groups.size());
  for (const auto& group : groups) {
    summaries.push_back(summaryOf(group));
  }
  return summaries;
}

} // namespace dewpoint::experiment
