// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/bar_measures.h"

#include "core/base/statistics.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dewpoint::experiment {
namespace {

MeasuredRuns runsOf(const MeasuredRuns& runs, const std::string& scenario) {
  MeasuredRuns same;
  std::ranges::copy_if(runs, std::back_inserter(same),
                       [&](const SuiteResult* run) { return run->row.key.scenario == scenario; });
  return same;
}

/// The scenarios of some runs, each once, in the order of the runs.
std::vector<std::string> scenariosOf(const MeasuredRuns& runs) {
  std::vector<std::string> names;
  for (const SuiteResult* run : runs) {
    if (std::ranges::find(names, run->row.key.scenario) == names.end()) {
      names.push_back(run->row.key.scenario);
    }
  }
  return names;
}

ScenarioSummary beliefOver(const MeasuredRuns& runs, const BeliefMetric& metric) {
  std::vector<ScenarioValue> values;
  for (const std::string& scenario : scenariosOf(runs)) {
    values.push_back({scenario, metric.compute(runsOf(runs, scenario))});
  }
  return summarizeScenarios(values, metric.lessIsBetter);
}

/// Our runs, each with the other of the same scenario and seed, where there is one.
std::vector<std::pair<const SuiteResult*, const SuiteResult*>>
sameFrames(const MeasuredRuns& ours, const MeasuredRuns& others) {
  std::vector<std::pair<const SuiteResult*, const SuiteResult*>> pairs;
  for (const SuiteResult* run : ours) {
    const auto same = std::ranges::find_if(others, [&](const SuiteResult* other) {
      return other->row.key.seed == run->row.key.seed &&
             other->row.key.scenario == run->row.key.scenario;
    });
    if (same != others.end()) {
      pairs.emplace_back(run, *same);
    }
  }
  return pairs;
}

/// RMSE of one run against another of the same frames, where both declare the target.
double ratioOf(const SuiteTrace& ours, const SuiteTrace& other) {
  double squares = 0.0;
  double otherSquares = 0.0;
  for (std::size_t target = 0; target < std::min(ours.errorsMm.size(), other.errorsMm.size());
       ++target) {
    const auto& one = ours.errorsMm[target];
    const auto& two = other.errorsMm[target];
    for (std::size_t frame = 0; frame < std::min(one.size(), two.size()); ++frame) {
      if (std::isfinite(one[frame]) && std::isfinite(two[frame])) {
        squares += one[frame] * one[frame];
        otherSquares += two[frame] * two[frame];
      }
    }
  }
  return otherSquares > 0.0 ? std::sqrt(squares / otherSquares) : kNoValue;
}

} // namespace

RequirementMeasure quantileOverRuns(ResultColumn column, double fraction) {
  return [=](const MeasuredRuns& ours, const MeasuredRuns&) {
    return columnQuantile(ours, column, fraction);
  };
}

RequirementMeasure worstRun(ResultColumn column) {
  return quantileOverRuns(column, 1.0);
}

RequirementMeasure worstMedian(ResultColumn column) {
  return maxOverScenarios(quantileOverRuns(column, 0.5));
}

RequirementMeasure meanOverRuns(ResultColumn column, double factor) {
  return
      [=](const MeasuredRuns& ours, const MeasuredRuns&) { return factor * meanOf(ours, column); };
}

RequirementMeasure percentWithin(ResultColumn column, double limit) {
  return [=](const MeasuredRuns& ours, const MeasuredRuns&) {
    const auto values = columnValues(ours, column);
    const auto within = std::ranges::count_if(values, [&](double v) { return v <= limit; });
    return values.empty()
               ? kNoValue
               : inPercent(static_cast<double>(within)) / static_cast<double>(values.size());
  };
}

RequirementMeasure failureCount(ResultColumn column) {
  return [=](const MeasuredRuns& ours, const MeasuredRuns&) {
    const auto values = columnValues(ours, column);
    return values.empty() ? kNoValue
                          : static_cast<double>(std::ranges::count_if(
                                values, [](double v) { return std::isinf(v); }));
  };
}

RequirementValue pooledP95(const MeasuredRuns& ours, const MeasuredRuns&) {
  std::vector<double> all;
  for (const auto& errors : errorsAfterConvergence(ours)) {
    all.insert(all.end(), errors.begin(), errors.end());
  }
  std::ranges::sort(all);
  return all.empty() ? kNoValue : quantile(all, 0.95);
}

RequirementValue pooledEceOfRuns(const MeasuredRuns& ours, const MeasuredRuns&) {
  return pooledReliability(ours).expectedCalibrationError;
}

RequirementValue depthBias(const MeasuredRuns& ours, const MeasuredRuns&) {
  return std::abs(meanOf(ours, &SuiteRow::depthBiasMm));
}

RequirementValue rmseRatioToTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others) {
  return columnQuantile(ours, &SuiteRow::rmseMm, 0.5) /
         columnQuantile(others, &SuiteRow::rmseMm, 0.5);
}

RequirementValue rmseRatioOnSharedFrames(const MeasuredRuns& ours, const MeasuredRuns& others) {
  std::vector<double> ratios;
  for (const auto& [run, other] : sameFrames(ours, others)) {
    const double ratio = ratioOf(run->trace, other->trace);
    if (!std::isnan(ratio)) {
      ratios.push_back(ratio);
    }
  }
  return ratios.empty() ? kNoValue : median(std::move(ratios));
}

RequirementValue lostFramesOverTriangulation(const MeasuredRuns& ours, const MeasuredRuns& others) {
  double sum = 0.0;
  int count = 0;
  for (const auto& [run, other] : sameFrames(ours, others)) {
    if (run->row.lostPercent && other->row.lostPercent) {
      sum += *run->row.lostPercent - *other->row.lostPercent;
      ++count;
    }
  }
  return count > 0 ? sum / count : kNoValue;
}

RequirementMeasure medianOverScenarios(const BeliefMetric& metric) {
  return [&metric](const MeasuredRuns& ours, const MeasuredRuns&) {
    return beliefOver(ours, metric).medianValue;
  };
}

RequirementMeasure worstOverScenarios(const BeliefMetric& metric) {
  return [&metric](const MeasuredRuns& ours, const MeasuredRuns&) {
    ScenarioSummary over = beliefOver(ours, metric);
    return RequirementValue(over.worstValue, std::move(over.worstScenario));
  };
}

RequirementMeasure maxOverScenarios(RequirementMeasure measure) {
  return [measure = std::move(measure)](const MeasuredRuns& ours, const MeasuredRuns& others) {
    std::vector<ScenarioValue> values;
    for (const std::string& scenario : scenariosOf(ours)) {
      values.push_back({scenario, measure(runsOf(ours, scenario), runsOf(others, scenario)).value});
    }
    ScenarioSummary over = summarizeScenarios(values, true);
    return RequirementValue(over.worstValue, std::move(over.worstScenario));
  };
}

} // namespace dewpoint::experiment
