// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/aim_bars.h"

#include "core/experiment/metrics/chi_square.h"
#include "core/experiment/metrics/consistency.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kAnyHigh = std::numeric_limits<double>::infinity();
constexpr int kBeliefItem = 7;
constexpr int kAccuracyItem = 8;
/// Calibration error of P(exists) in every grade: the present requirement of grade `ideal`.
constexpr double kGreatestEce = 0.05;

/// What a grade asks of the stated belief.
struct BeliefLimits {
  const char* grade;
  double covered;                     ///< least percent of truths in the 95 % ellipsoid...
  double coveredAtMost;               ///< ... and the greatest: more is too vague
  std::optional<double> coveredWorst; ///< least percent in any scenario
  std::optional<double> sureAndWrong; ///< greatest percent of frames in any scenario
  bool existence;                     ///< whether P(exists) has a bar of its own here
};

/// `ideal` has a bar for coverage and one for P(exists) already, and nothing of what `room` asks
/// may be missed where the images are kinder. Recordings are asked for coverage alone.
constexpr BeliefLimits kLimits[] = {
    {"ideal", 92.0, 98.0, 80.0, 0.5, false},
    {"room", 90.0, 98.0, 80.0, 0.5, true},
    {"wild", 85.0, 99.0, std::nullopt, 2.0, true},
    {"real", 85.0, 99.0, std::nullopt, std::nullopt, false},
};

double rounded(double value) {
  return std::round(10.0 * value) / 10.0;
}

/// By which factor the squared errors exceed the stated variances when this percentage of them lies
/// in the 95 % ellipsoid, and are normal.
double excessAt(double coveredPercent) {
  return kChiSquared95ThreeDof / chiSquareQuantile(coveredPercent / 100.0, 3.0);
}

/// The percentage in the 50 % ellipsoid that goes with one in the 95 % ellipsoid.
double within50At(double coveredPercent) {
  return rounded(100.0 *
                 chiSquareProbability(kChiSquared50ThreeDof / excessAt(coveredPercent), 3.0));
}

double neesAt(double coveredPercent) {
  return rounded(3.0 * excessAt(coveredPercent));
}

SuiteBar aim(int item, const char* grade, std::string sentence, std::string unit, double low,
             double high, BarMeasure measure, std::vector<std::string> scenarios = {}) {
  return {item, std::move(sentence),  std::move(unit),    low,
          high, std::move(scenarios), std::move(measure), grade,
          true};
}

/// The median of the scenarios. Each bound of the 50 % ellipsoid and of NEES is the one that goes
/// with the bound of the 95 % ellipsoid: the three ask for the same.
void addConsistency(const BeliefLimits& limits, std::vector<SuiteBar>& bars) {
  bars.push_back(aim(kBeliefItem, limits.grade,
                     "Truth inside the stated 95 % ellipsoid, median of the scenarios", "%",
                     limits.covered, limits.coveredAtMost,
                     medianScenario(beliefFigure("coverage95_percent"))));
  bars.push_back(aim(kBeliefItem, limits.grade,
                     "Truth inside the stated 50 % ellipsoid, median of the scenarios", "%",
                     within50At(limits.covered), within50At(limits.coveredAtMost),
                     medianScenario(beliefFigure("coverage50_percent"))));
  bars.push_back(aim(
      kBeliefItem, limits.grade, "Normalized estimation error squared, median of the scenarios", "",
      neesAt(limits.coveredAtMost), neesAt(limits.covered), medianScenario(beliefFigure("nees"))));
}

void addBelief(const BeliefLimits& limits, std::vector<SuiteBar>& bars) {
  addConsistency(limits, bars);
  if (limits.coveredWorst) {
    bars.push_back(aim(
        kBeliefItem, limits.grade, "Truth inside the stated 95 % ellipsoid, worst scenario", "%",
        *limits.coveredWorst, kAnyHigh, worstScenario(beliefFigure("coverage95_percent"))));
  }
  if (limits.sureAndWrong) {
    bars.push_back(aim(
        kBeliefItem, limits.grade,
        "Sure and wrong: frames with P(exists) above 0.95 and farther off than three "
        "stated radii, worst scenario",
        "%", kAnyLow, *limits.sureAndWrong, worstScenario(beliefFigure("sure_and_wrong_percent"))));
  }
  if (limits.existence) {
    bars.push_back(aim(kBeliefItem, limits.grade,
                       "Expected calibration error of P(exists), all runs", "", kAnyLow,
                       kGreatestEce, pooledEceOfRuns));
  }
}

/// In every scenario at least as good as the same mask's centroids.
void addNeverBehind(const char* grade, std::vector<SuiteBar>& bars) {
  bars.push_back(aim(kAccuracyItem, grade,
                     "RMSE relative to paired triangulation, frames in which both declare the "
                     "target, worst scenario",
                     "x", kAnyLow, 1.0, greatestOfScenarios(sharedFramesRatio)));
  bars.push_back(aim(kAccuracyItem, grade,
                     "Frames lost minus those of paired triangulation, worst scenario", "%",
                     kAnyLow, 0.0, greatestOfScenarios(lostBeyondTriangulation)));
}

/// `least`: percent of the runs.
SuiteBar oneClick(const char* grade, double least) {
  return aim(kAccuracyItem, grade, "Learned by one click in one camera: runs that find the target",
             "%", least, kAnyHigh,
             percentWithin(&SuiteRow::framesToConverge, std::numeric_limits<double>::max()),
             {"S22"});
}

std::vector<SuiteBar> accuracyBars() {
  std::vector<SuiteBar> bars{
      aim(kAccuracyItem, "room", "Clean: median RMSE, worst scenario", "mm", kAnyLow, 2.5,
          worstMedian(&SuiteRow::rmseMm), {"S0"}),
      aim(kAccuracyItem, "room", "Clean: RMSE relative to paired triangulation, worst scenario",
          "x", kAnyLow, 0.8, greatestOfScenarios(againstTriangulation), {"S0"}),
      oneClick("room", 95.0),
      oneClick("wild", 85.0),
  };
  addNeverBehind("room", bars);
  addNeverBehind("real", bars);
  return bars;
}

} // namespace

std::vector<SuiteBar> aimBars() {
  std::vector<SuiteBar> bars;
  for (const BeliefLimits& limits : kLimits) {
    addBelief(limits, bars);
  }
  for (SuiteBar& bar : accuracyBars()) {
    bars.push_back(std::move(bar));
  }
  return bars;
}

} // namespace dewpoint::experiment
