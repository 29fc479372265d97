// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/aim_bars.h"

#include "core/base/units.h"
#include "core/experiment/metrics/chi_square.h"
#include "core/experiment/metrics/consistency.h"
#include "core/experiment/metrics/tie_belief.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kNoUpperLimit = std::numeric_limits<double>::infinity();
constexpr int kBeliefItem = 7;
constexpr int kAccuracyItem = 8;
/// Expected calibration error of P(exists), in [0, 1], the same in every grade: of all runs and of
/// the median scenario what grade `ideal` has always been asked for...
constexpr double kGreatestEce = 0.05;
/// ... and of the worst scenario a bin of the reliability table, because the forecasts of a few
/// runs of one scenario depend on each other. A judgment.
constexpr double kGreatestEceOfScenario = 0.1;

/// What a grade asks of the stated belief. Percent.
struct BeliefLimits {
  const char* grade;
  double covered;          ///< least share of truths in the 95 % ellipsoid...
  double coveredAtMost;    ///< ... and the greatest: more is too vague
  double coveredWorst;     ///< least share in any scenario
  double confidentlyWrong; ///< greatest share of frames in any scenario
  std::optional<double>
      confidentInTieShare; ///< the same; nothing where no run has equal candidates
  bool existence;          ///< whether P(exists) has a bar over all runs, too
};

/// `ideal` has a bar for P(exists) over all runs already, and nothing of what `room` asks may be
/// missed where the images are kinder. The worst scenario of `wild` and `real` may be as far below
/// the median as that of `room`, and recordings may be as often sure and wrong as `wild`. To be
/// sure without a reason is as bad as to be sure and wrong.
constexpr BeliefLimits kLimits[] = {
    {"ideal", 92.0, 98.0, 80.0, 0.5, 0.5, false},
    {"room", 90.0, 98.0, 80.0, 0.5, 0.5, true},
    {"wild", 85.0, 99.0, 75.0, 2.0, 2.0, true},
    {"real", 85.0, 99.0, 75.0, 2.0, std::nullopt, false},
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
  return rounded(
      inPercent(chiSquareProbability(kChiSquared50ThreeDof / excessAt(coveredPercent), 3.0)));
}

double neesAt(double coveredPercent) {
  return rounded(3.0 * excessAt(coveredPercent));
}

SuiteRequirement aim(int item, const char* grade, std::string sentence, std::string unit,
                     double low, double high, RequirementMeasure measure,
                     std::vector<std::string> scenarios = {}) {
  return {item, std::move(sentence),  std::move(unit),    low,
          high, std::move(scenarios), std::move(measure), grade,
          true};
}

struct Bounds {
  double low;
  double high;
};

/// Two bars for a figure of belief: the median of the scenarios, and the worst of them.
void addBothWays(const char* grade, const std::string& sentence, const std::string& unit,
                 const std::string& figure, const Bounds& median, const Bounds& worst,
                 std::vector<SuiteRequirement>& bars) {
  bars.push_back(aim(kBeliefItem, grade, sentence + ", median of the scenarios", unit, median.low,
                     median.high, medianOverScenarios(beliefMetric(figure))));
  bars.push_back(aim(kBeliefItem, grade, sentence + ", worst scenario", unit, worst.low, worst.high,
                     worstOverScenarios(beliefMetric(figure))));
}

/// Each bound of the 50 % ellipsoid and of NEES is the one that goes with the bound of the 95 %
/// ellipsoid: the three ask for the same. The worst scenario is the one that is too sure.
void addConsistency(const BeliefLimits& limits, std::vector<SuiteRequirement>& bars) {
  addBothWays(limits.grade, "Truth inside the stated 95 % ellipsoid", "%", "coverage95_percent",
              {limits.covered, limits.coveredAtMost}, {limits.coveredWorst, kNoUpperLimit}, bars);
  addBothWays(limits.grade, "Truth inside the stated 50 % ellipsoid", "%", "coverage50_percent",
              {within50At(limits.covered), within50At(limits.coveredAtMost)},
              {within50At(limits.coveredWorst), kNoUpperLimit}, bars);
  addBothWays(limits.grade, "Normalized estimation error squared", "", "nees",
              {neesAt(limits.coveredAtMost), neesAt(limits.covered)},
              {kNoLowerLimit, neesAt(limits.coveredWorst)}, bars);
}

void addBelief(const BeliefLimits& limits, std::vector<SuiteRequirement>& bars) {
  addConsistency(limits, bars);
  addBothWays(limits.grade,
              "Sure and wrong: frames with P(exists) above 0.95 and farther off than three stated "
              "radii",
              "%", "sure_and_wrong_percent", {kNoLowerLimit, limits.confidentlyWrong},
              {kNoLowerLimit, limits.confidentlyWrong}, bars);
  addBothWays(limits.grade, "Expected calibration error of P(exists)", "", "existence_ece",
              {kNoLowerLimit, kGreatestEce}, {kNoLowerLimit, kGreatestEceOfScenario}, bars);
  if (limits.existence) {
    bars.push_back(aim(kBeliefItem, limits.grade,
                       "Expected calibration error of P(exists), all runs", "", kNoLowerLimit,
                       kGreatestEce, pooledEceOfRuns));
  }
  if (limits.confidentInTieShare) {
    bars.push_back(aim(
        kBeliefItem, limits.grade,
        fmt::format("Sure of a tie: frames with P(exists) more than {:g} above one over the number "
                    "of equal candidates, worst scenario",
                    kTieMargin),
        "%", kNoLowerLimit, *limits.confidentInTieShare,
        worstOverScenarios(beliefMetric("sure_of_tie_percent")), {"S19-even-start"}));
  }
}

/// In every scenario at least as good as the same mask's centroids.
void addNeverBehind(const char* grade, std::vector<SuiteRequirement>& bars) {
  bars.push_back(aim(kAccuracyItem, grade,
                     "RMSE relative to paired triangulation, frames in which both declare the "
                     "target, worst scenario",
                     "x", kNoLowerLimit, 1.0, maxOverScenarios(rmseRatioOnSharedFrames)));
  bars.push_back(aim(kAccuracyItem, grade,
                     "Frames lost minus those of paired triangulation, worst scenario", "%",
                     kNoLowerLimit, 0.0, maxOverScenarios(lostFramesOverTriangulation)));
}

/// `least`: percent of the runs.
SuiteRequirement oneClick(const char* grade, double least) {
  return aim(kAccuracyItem, grade, "Learned by one click in one camera: runs that find the target",
             "%", least, kNoUpperLimit,
             percentWithin(&SuiteRow::framesToConverge, std::numeric_limits<double>::max()),
             {"S22"});
}

std::vector<SuiteRequirement> accuracyBars() {
  std::vector<SuiteRequirement> bars{
      aim(kAccuracyItem, "room", "Clean: median RMSE, worst scenario", "mm", kNoLowerLimit, 2.5,
          worstMedian(&SuiteRow::rmseMm), {"S0"}),
      aim(kAccuracyItem, "room", "Clean: RMSE relative to paired triangulation, worst scenario",
          "x", kNoLowerLimit, 0.8, maxOverScenarios(rmseRatioToTriangulation), {"S0"}),
      oneClick("room", 95.0),
      oneClick("wild", 85.0),
  };
  addNeverBehind("room", bars);
  addNeverBehind("real", bars);
  return bars;
}

} // namespace

std::vector<SuiteRequirement> aimRequirements() {
  std::vector<SuiteRequirement> bars;
  for (const BeliefLimits& limits : kLimits) {
    addBelief(limits, bars);
  }
  for (SuiteRequirement& bar : accuracyBars()) {
    bars.push_back(std::move(bar));
  }
  return bars;
}

} // namespace dewpoint::experiment
