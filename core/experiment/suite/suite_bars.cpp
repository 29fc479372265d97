// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_bars.h"

#include "core/base/statistics.h"
#include "core/trajectory/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

using Runs = std::vector<const SuiteResult*>;
using Figure = SuiteRow::Figure SuiteRow::*;
using Measure = std::function<double(const Runs&, const Runs&)>;

constexpr const char* kOurs = "dewpoint";
constexpr const char* kOther = "triangulation";
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kAnyLow = -std::numeric_limits<double>::infinity();

Measure quantileAt(Figure figure, double fraction) {
  return [=](const Runs& ours, const Runs&) { return quantileOf(ours, figure, fraction); };
}

Measure worst(Figure figure) {
  return quantileAt(figure, 1.0);
}

/// The largest of the scenarios' medians over runs.
Measure worstMedian(Figure figure) {
  return [=](const Runs& ours, const Runs&) {
    double result = kNothing;
    for (const SuiteResult* first : ours) {
      Runs same;
      std::ranges::copy_if(ours, std::back_inserter(same), [&](const SuiteResult* run) {
        return run->row.key.scenario == first->row.key.scenario;
      });
      result = std::fmax(result, quantileOf(same, figure, 0.5));
    }
    return result;
  };
}

/// Percent of runs whose figure is at most `limit`.
Measure percentWithin(Figure figure, double limit) {
  return [=](const Runs& ours, const Runs&) {
    const auto values = figuresOf(ours, figure);
    const auto within = std::ranges::count_if(values, [&](double v) { return v <= limit; });
    return values.empty()
               ? kNothing
               : 100.0 * static_cast<double>(within) / static_cast<double>(values.size());
  };
}

/// Runs in which it never happened.
Measure failures(Figure figure) {
  return [=](const Runs& ours, const Runs&) {
    const auto values = figuresOf(ours, figure);
    return values.empty() ? kNothing
                          : static_cast<double>(std::ranges::count_if(
                                values, [](double v) { return std::isinf(v); }));
  };
}

double pooledP95(const Runs& ours, const Runs&) {
  std::vector<double> all;
  for (const auto& errors : errorsAfterConvergence(ours)) {
    all.insert(all.end(), errors.begin(), errors.end());
  }
  std::ranges::sort(all);
  return all.empty() ? kNothing : quantile(all, 0.95);
}

double againstTriangulation(const Runs& ours, const Runs& others) {
  return quantileOf(ours, &SuiteRow::rmseMm, 0.5) / quantileOf(others, &SuiteRow::rmseMm, 0.5);
}

double depthBias(const Runs& ours, const Runs&) {
  return std::abs(meanOf(ours, &SuiteRow::depthBiasMm));
}

double meanCoverage(const Runs& ours, const Runs&) {
  return meanOf(ours, &SuiteRow::coverage95Percent);
}

double meanFalseAlarms(const Runs& ours, const Runs&) {
  return meanOf(ours, &SuiteRow::falseAlarmPercent) / 100.0;
}

double pooledEce(const Runs& ours, const Runs&) {
  return pooledReliability(ours).expectedError;
}

/// At most `high`.
SuiteBar most(int item, std::string sentence, std::string unit, double high,
              std::vector<std::string> scenarios, Measure measure) {
  return {item, std::move(sentence),  std::move(unit),   kAnyLow,
          high, std::move(scenarios), std::move(measure)};
}

std::vector<SuiteBar> startBars() {
  const Measure quick = percentWithin(&SuiteRow::framesToConverge, kQuickFrames);
  return {
      {1,
       "Desk box, cloud and point starts: converged within 5 frames",
       "%",
       100.0,
       100.0,
       {"S4-desk-cloud", "S4-desk-point"},
       quick},
      {1,
       "Room, cloud and point starts: converged within 5 frames",
       "%",
       99.5,
       100.0,
       {"S4-room-cloud", "S4-room-point"},
       quick},
  };
}

std::vector<SuiteBar> cleanBars() {
  return {
      most(2, "Clean, slow: median RMSE", "mm", 1.1, {"S0-slow"},
           quantileAt(&SuiteRow::rmseMm, 0.5)),
      most(2, "Clean, fast: median RMSE", "mm", 1.2, {"S0-fast"},
           quantileAt(&SuiteRow::rmseMm, 0.5)),
      most(2, "Clean: 95th percentile of the error", "mm", 1.9, {"S0"}, pooledP95),
      most(2, "Clean, slow: RMSE relative to triangulation of the same mask", "x", 1.05,
           {"S0-slow"}, againstTriangulation),
      most(2, "Clean, fast: RMSE relative to triangulation of the same mask", "x", 1.05,
           {"S0-fast"}, againstTriangulation),
      most(2, "Clean: depth bias", "mm", 1.0, {"S0"}, depthBias),
  };
}

std::vector<SuiteBar> disturbedBars() {
  const std::vector<std::string> blind{"S3-one-blind"};
  return {
      most(3, "Look-alikes: frames lost, worst run", "%", 0.0, {"S1"},
           worst(&SuiteRow::lostPercent)),
      most(3, "Look-alikes: median RMSE, worst scenario", "mm", 4.0, {"S1"},
           worstMedian(&SuiteRow::rmseMm)),
      most(3, "Half hidden in one of two cameras: median RMSE, worst scenario", "mm", 10.0,
           {"S2-still", "S2-moving"}, worstMedian(&SuiteRow::rmseMm)),
      most(3, "Half hidden, with a third camera: median RMSE", "mm", 3.0, {"S2-three-cameras"},
           worstMedian(&SuiteRow::rmseMm)),
      most(3, "One of two cameras blind for 0.5 s: RMSE meanwhile, median", "mm", 14.0, blind,
           quantileAt(&SuiteRow::blackoutRmseMm, 0.5)),
      most(3, "One of two cameras blind for 0.5 s: RMSE meanwhile, 90th percentile", "mm", 40.0,
           blind, quantileAt(&SuiteRow::blackoutRmseMm, 0.9)),
      most(3, "One of three cameras blind for 0.5 s: RMSE meanwhile, median", "mm", 2.0,
           {"S3-one-blind-three-cameras"}, quantileAt(&SuiteRow::blackoutRmseMm, 0.5)),
  };
}

std::vector<SuiteBar> jumpBars() {
  const Figure found = &SuiteRow::framesToReacquire;
  return {
      most(4, "Jump of 0.355 m: runs that never find it again", "", 0.0, {"S4-jump-desk"},
           failures(found)),
      most(4, "Jump of 0.355 m: frames to find it again, 90th percentile", "frames", 2.0,
           {"S4-jump-desk"}, quantileAt(found, 0.9)),
      most(4, "Jump of 2 m in the room: runs that never find it again", "", 0.0, {"S4-jump-room"},
           failures(found)),
      most(4, "Jump of 2 m in the room: frames to find it again, 90th percentile", "frames", 5.0,
           {"S4-jump-room"}, quantileAt(found, 0.9)),
  };
}

std::vector<SuiteBar> honestyBars() {
  return {
      most(5, "Vanished: frames until the loss is declared, worst run", "frames", 3.0,
           {"S3-vanish"}, worst(&SuiteRow::framesToDeclareLoss)),
      most(5, "False alarms per frame, mean of all runs", "", 1e-3, {}, meanFalseAlarms),
      most(5, "Expected calibration error of P(exists), all runs", "", 0.05, {}, pooledEce),
      {5,
       "Truth inside the stated 95 % ellipsoid, mean of all runs",
       "%",
       92.0,
       98.0,
       {},
       meanCoverage},
  };
}

std::vector<SuiteBar> identityBars() {
  return {
      most(6, "Eight identical balls, 2 minutes, 4 cameras: identity switches, worst run", "", 2.0,
           {"S5-eight"}, worst(&SuiteRow::identitySwitches)),
      most(6, "A camera drops out or returns: step of the estimate, worst run", "mm", 1.0, {"S6"},
           worst(&SuiteRow::largestStepMm)),
  };
}

/// The runs a bar is measured on; every one where it names no scenario.
Runs runsFor(const SuiteBar& bar, const std::vector<SuiteCell>& cells, const std::string& method) {
  Runs runs;
  for (const SuiteCell& cell : cells) {
    const bool meant =
        bar.scenarios.empty() || std::ranges::any_of(bar.scenarios, [&](const std::string& name) {
          const bool family = name.find('-') == std::string::npos;
          return cell.scenario == name || (family && cell.scenario.starts_with(name + "-"));
        });
    if (meant && cell.grade == Grade::Ideal && cell.method == method) {
      runs.insert(runs.end(), cell.runs.begin(), cell.runs.end());
    }
  }
  return runs;
}

} // namespace

const std::vector<SuiteBar>& suiteBars() {
  static const std::vector<SuiteBar> all = [] {
    std::vector<SuiteBar> bars;
    for (const auto& part :
         {startBars(), cleanBars(), disturbedBars(), jumpBars(), honestyBars(), identityBars()}) {
      bars.insert(bars.end(), part.begin(), part.end());
    }
    return bars;
  }();
  return all;
}

bool BarResult::measured() const {
  return runs > 0 && !std::isnan(value);
}

bool BarResult::reached() const {
  return measured() && value >= bar->low && value <= bar->high;
}

double BarResult::shortfall() const {
  return std::max({0.0, bar->low - value, value - bar->high});
}

std::vector<BarResult> measureBars(const std::vector<SuiteCell>& cells) {
  std::vector<BarResult> results;
  for (const SuiteBar& bar : suiteBars()) {
    const Runs ours = runsFor(bar, cells, kOurs);
    const Runs others = runsFor(bar, cells, kOther);
    results.push_back({&bar, ours.size(), ours.empty() ? kNothing : bar.measure(ours, others)});
  }
  return results;
}

} // namespace dewpoint::experiment
