// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_bars.h"

#include "core/experiment/suite/aim_bars.h"
#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr const char* kOther = "triangulation";

/// The families of the first version's requirements. What is asked of all runs of grade `ideal`
/// was set for these; the families after them are judged by the figures of belief
/// (aimRequirements()).
const std::vector<std::string>& firstFamilies() {
  static const std::vector<std::string> kFamilies{"S0", "S1", "S2", "S3", "S4", "S5",
                                                  "S6", "S7", "S8", "S9", "S10"};
  return kFamilies;
}

/// At most `high`.
SuiteRequirement most(int item, std::string sentence, std::string unit, double high,
                      std::vector<std::string> scenarios, RequirementMeasure measure) {
  return {item, std::move(sentence),  std::move(unit),   kNoLowerLimit,
          high, std::move(scenarios), std::move(measure)};
}

std::vector<SuiteRequirement> startBars() {
  const RequirementMeasure quick = percentWithin(&SuiteRow::framesToConverge, kQuickFrames);
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

std::vector<SuiteRequirement> cleanBars() {
  return {
      most(2, "Clean, slow: median RMSE", "mm", 1.1, {"S0-slow"},
           quantileOverRuns(&SuiteRow::rmseMm, 0.5)),
      most(2, "Clean, fast: median RMSE", "mm", 1.2, {"S0-fast"},
           quantileOverRuns(&SuiteRow::rmseMm, 0.5)),
      most(2, "Clean: 95th percentile of the error", "mm", 1.9, {"S0"}, pooledP95),
      most(2, "Clean, slow: RMSE relative to triangulation of the same mask", "x", 1.05,
           {"S0-slow"}, rmseRatioToTriangulation),
      most(2, "Clean, fast: RMSE relative to triangulation of the same mask", "x", 1.05,
           {"S0-fast"}, rmseRatioToTriangulation),
      most(2, "Clean: depth bias", "mm", 1.0, {"S0"}, depthBias),
  };
}

std::vector<SuiteRequirement> disturbedBars() {
  const std::vector<std::string> blind{"S3-one-blind"};
  return {
      most(3, "Distractors: frames lost, worst run", "%", 0.0, {"S1"},
           worstRun(&SuiteRow::lostPercent)),
      most(3, "Distractors: median RMSE, worst scenario", "mm", 4.0, {"S1"},
           worstMedian(&SuiteRow::rmseMm)),
      most(3, "Half hidden in one of two cameras: median RMSE, worst scenario", "mm", 10.0,
           {"S2-still", "S2-moving"}, worstMedian(&SuiteRow::rmseMm)),
      most(3, "Half hidden, with a third camera: median RMSE", "mm", 3.0, {"S2-three-cameras"},
           worstMedian(&SuiteRow::rmseMm)),
      most(3, "One of two cameras blind for 0.5 s: RMSE meanwhile, median", "mm", 14.0, blind,
           quantileOverRuns(&SuiteRow::blackoutRmseMm, 0.5)),
      most(3, "One of two cameras blind for 0.5 s: RMSE meanwhile, 90th percentile", "mm", 40.0,
           blind, quantileOverRuns(&SuiteRow::blackoutRmseMm, 0.9)),
      most(3, "One of three cameras blind for 0.5 s: RMSE meanwhile, median", "mm", 2.0,
           {"S3-one-blind-three-cameras"}, quantileOverRuns(&SuiteRow::blackoutRmseMm, 0.5)),
  };
}

std::vector<SuiteRequirement> jumpBars() {
  const ResultColumn found = &SuiteRow::framesToReacquire;
  return {
      most(4, "Jump of 0.355 m: runs that never find it again", "", 0.0, {"S4-jump-desk"},
           failureCount(found)),
      most(4, "Jump of 0.355 m: frames to find it again, 90th percentile", "frames", 2.0,
           {"S4-jump-desk"}, quantileOverRuns(found, 0.9)),
      most(4, "Jump of 2 m in the room: runs that never find it again", "", 0.0, {"S4-jump-room"},
           failureCount(found)),
      most(4, "Jump of 2 m in the room: frames to find it again, 90th percentile", "frames", 5.0,
           {"S4-jump-room"}, quantileOverRuns(found, 0.9)),
  };
}

std::vector<SuiteRequirement> honestyBars() {
  return {
      most(5, "Vanished: frames until the loss is declared, worst run", "frames", 3.0,
           {"S3-vanish"}, worstRun(&SuiteRow::framesToDeclareLoss)),
      most(5, "False alarms per frame, mean of all runs of S0 to S10", "", 1e-3, firstFamilies(),
           meanOverRuns(&SuiteRow::falseAlarmPercent, 0.01)),
      most(5, "Expected calibration error of P(exists), all runs of S0 to S10", "", 0.05,
           firstFamilies(), pooledEceOfRuns),
      {5, "Truth inside the stated 95 % ellipsoid, mean of all runs of S0 to S10", "%", 92.0, 98.0,
       firstFamilies(), meanOverRuns(&SuiteRow::coverage95Percent)},
  };
}

std::vector<SuiteRequirement> identityBars() {
  return {
      most(6, "Eight identical balls, 2 minutes, 4 cameras: identity switches, worst run", "", 2.0,
           {"S5-eight"}, worstRun(&SuiteRow::identitySwitches)),
      most(6, "A camera drops out or returns: step of the estimate, worst run", "mm", 1.0, {"S6"},
           worstRun(&SuiteRow::largestStepMm)),
  };
}

/// The runs of a method that a bar is measured on; of every scenario where it names none.
MeasuredRuns runsFor(const SuiteRequirement& bar, const std::vector<SuiteCell>& cells,
                     std::string_view method) {
  MeasuredRuns runs;
  for (const SuiteCell& cell : cells) {
    const bool meant =
        bar.scenarios.empty() || std::ranges::any_of(bar.scenarios, [&](const std::string& name) {
          const bool family = name.find('-') == std::string::npos;
          return cell.scenario == name || (family && cell.scenario.starts_with(name + "-"));
        });
    if (meant && gradeName(cell.grade) == bar.grade && cell.method == method) {
      runs.insert(runs.end(), cell.runs.begin(), cell.runs.end());
    }
  }
  return runs;
}

} // namespace

const std::vector<SuiteRequirement>& suiteRequirements() {
  static const std::vector<SuiteRequirement> all = [] {
    std::vector<SuiteRequirement> bars;
    for (const auto& part : {startBars(), cleanBars(), disturbedBars(), jumpBars(), honestyBars(),
                             identityBars(), aimRequirements()}) {
      bars.insert(bars.end(), part.begin(), part.end());
    }
    return bars;
  }();
  return all;
}

bool RequirementResult::isMeasured() const {
  return runCount > 0 && !std::isnan(value);
}

bool RequirementResult::isMet() const {
  return isMeasured() && value >= requirement->lowerLimit && value <= requirement->upperLimit;
}

double RequirementResult::shortfall() const {
  return std::max({0.0, requirement->lowerLimit - value, value - requirement->upperLimit});
}

std::vector<RequirementResult> measureRequirements(const std::vector<SuiteCell>& cells) {
  std::vector<RequirementResult> results;
  for (const SuiteRequirement& bar : suiteRequirements()) {
    const MeasuredRuns ours = runsFor(bar, cells, defaultMethod());
    const MeasuredRuns others = runsFor(bar, cells, kOther);
    const RequirementValue figure =
        ours.empty() ? RequirementValue(kNoValue) : bar.measure(ours, others);
    results.push_back({&bar, ours.size(), figure.value, figure.scenario});
  }
  return results;
}

} // namespace dewpoint::experiment
