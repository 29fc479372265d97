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

BarRuns runsOf(const BarRuns& runs, const std::string& scenario) {
  BarRuns same;
  std::ranges::copy_if(runs, std::back_inserter(same),
                       [&](const SuiteResult* run) { return run->row.key.scenario == scenario; });
  return same;
}

/// The scenarios of some runs, each once, in the order of the runs.
std::vector<std::string> scenariosOf(const BarRuns& runs) {
  std::vector<std::string> names;
  for (const SuiteResult* run : runs) {
    if (std::ranges::find(names, run->row.key.scenario) == names.end()) {
      names.push_back(run->row.key.scenario);
    }
  }
  return names;
}

OverScenarios beliefOver(const BarRuns& runs, const BeliefMetric& metric) {
  std::vector<ScenarioValue> values;
  for (const std::string& scenario : scenariosOf(runs)) {
    values.push_back({scenario, metric.of(runsOf(runs, scenario))});
  }
  return overScenarios(values, metric.lessIsBetter);
}

/// Our runs, each with the other of the same scenario and seed, where there is one.
std::vector<std::pair<const SuiteResult*, const SuiteResult*>> sameFrames(const BarRuns& ours,
                                                                          const BarRuns& others) {
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
  return otherSquares > 0.0 ? std::sqrt(squares / otherSquares) : kNoFigure;
}

} // namespace

BarMeasure quantileAt(BarColumn figure, double fraction) {
  return [=](const BarRuns& ours, const BarRuns&) { return quantileOf(ours, figure, fraction); };
}

BarMeasure worstRun(BarColumn figure) {
  return quantileAt(figure, 1.0);
}

BarMeasure worstMedian(BarColumn figure) {
  return greatestOfScenarios(quantileAt(figure, 0.5));
}

BarMeasure meanOfRuns(BarColumn figure, double factor) {
  return [=](const BarRuns& ours, const BarRuns&) { return factor * meanOf(ours, figure); };
}

BarMeasure percentWithin(BarColumn figure, double limit) {
  return [=](const BarRuns& ours, const BarRuns&) {
    const auto values = figuresOf(ours, figure);
    const auto within = std::ranges::count_if(values, [&](double v) { return v <= limit; });
    return values.empty()
               ? kNoFigure
               : inPercent(static_cast<double>(within)) / static_cast<double>(values.size());
  };
}

BarMeasure failures(BarColumn figure) {
  return [=](const BarRuns& ours, const BarRuns&) {
    const auto values = figuresOf(ours, figure);
    return values.empty() ? kNoFigure
                          : static_cast<double>(std::ranges::count_if(
                                values, [](double v) { return std::isinf(v); }));
  };
}

BarFigure pooledP95(const BarRuns& ours, const BarRuns&) {
  std::vector<double> all;
  for (const auto& errors : errorsAfterConvergence(ours)) {
    all.insert(all.end(), errors.begin(), errors.end());
  }
  std::ranges::sort(all);
  return all.empty() ? kNoFigure : quantile(all, 0.95);
}

BarFigure pooledEceOfRuns(const BarRuns& ours, const BarRuns&) {
  return pooledReliability(ours).expectedError;
}

BarFigure depthBias(const BarRuns& ours, const BarRuns&) {
  return std::abs(meanOf(ours, &SuiteRow::depthBiasMm));
}

BarFigure againstTriangulation(const BarRuns& ours, const BarRuns& others) {
  return quantileOf(ours, &SuiteRow::rmseMm, 0.5) / quantileOf(others, &SuiteRow::rmseMm, 0.5);
}

BarFigure sharedFramesRatio(const BarRuns& ours, const BarRuns& others) {
  std::vector<double> ratios;
  for (const auto& [run, other] : sameFrames(ours, others)) {
    const double ratio = ratioOf(run->trace, other->trace);
    if (!std::isnan(ratio)) {
      ratios.push_back(ratio);
    }
  }
  return ratios.empty() ? kNoFigure : median(std::move(ratios));
}

BarFigure lostBeyondTriangulation(const BarRuns& ours, const BarRuns& others) {
  double sum = 0.0;
  int count = 0;
  for (const auto& [run, other] : sameFrames(ours, others)) {
    if (run->row.lostPercent && other->row.lostPercent) {
      sum += *run->row.lostPercent - *other->row.lostPercent;
      ++count;
    }
  }
  return count > 0 ? sum / count : kNoFigure;
}

BarMeasure medianScenario(const BeliefMetric& metric) {
  return [&metric](const BarRuns& ours, const BarRuns&) { return beliefOver(ours, metric).median; };
}

BarMeasure worstScenario(const BeliefMetric& metric) {
  return [&metric](const BarRuns& ours, const BarRuns&) {
    OverScenarios over = beliefOver(ours, metric);
    return BarFigure(over.worst, std::move(over.worstScenario));
  };
}

BarMeasure greatestOfScenarios(BarMeasure measure) {
  return [measure = std::move(measure)](const BarRuns& ours, const BarRuns& others) {
    std::vector<ScenarioValue> values;
    for (const std::string& scenario : scenariosOf(ours)) {
      values.push_back({scenario, measure(runsOf(ours, scenario), runsOf(others, scenario)).value});
    }
    OverScenarios over = overScenarios(values, true);
    return BarFigure(over.worst, std::move(over.worstScenario));
  };
}

} // namespace dewpoint::experiment
