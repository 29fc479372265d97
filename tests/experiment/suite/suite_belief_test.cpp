// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_belief.h"
#include "tests/experiment/suite/suite_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

TEST(ScenarioSummary, GivesMedianAndWorstByName) {
  const std::vector<ScenarioValue> values{{"a", 97.0}, {"b", 46.0}, {"c", kNothing}, {"d", 90.0}};
  const ScenarioSummary covered = summarizeScenarios(values, false);
  EXPECT_EQ(covered.medianValue, 90.0);
  EXPECT_EQ(covered.worstValue, 46.0);
  EXPECT_EQ(covered.worstScenario, "b");
  const ScenarioSummary wrong = summarizeScenarios(values, true);
  EXPECT_EQ(wrong.worstValue, 97.0);
  EXPECT_EQ(wrong.worstScenario, "a");
}

TEST(ScenarioSummary, TakesTheMiddleOfTwoAndTheFirstOfEquals) {
  const std::vector<ScenarioValue> values{{"a", 1.0}, {"b", 4.0}, {"c", 2.0}, {"d", 4.0}};
  EXPECT_EQ(summarizeScenarios(values, true).medianValue, 3.0);
  EXPECT_EQ(summarizeScenarios(values, true).worstScenario, "b");
}

TEST(ScenarioSummary, OfNothingIsNothing) {
  const std::vector<ScenarioValue> values{{"a", kNothing}};
  EXPECT_TRUE(std::isnan(summarizeScenarios(values, true).medianValue));
  EXPECT_TRUE(std::isnan(summarizeScenarios({}, true).worstValue));
  EXPECT_TRUE(summarizeScenarios(values, false).worstScenario.empty());
}

TEST(BeliefMetrics, AreMeansOverRunsButForNeesAndCalibration) {
  MadeResults made;
  const double coverages[] = {80.0, 90.0, 97.0}; // mean 89
  const double nees[] = {1.0, 30.0, 5.0};        // median 5, mean 12
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SuiteResult result = resultOf("S0-slow", Grade::Room, "dewpoint", seed);
    result.row.coverage95Percent = coverages[seed];
    result.row.nees = nees[seed];
    result.row.confidentlyWrongPercent = static_cast<double>(seed); // mean 1
    // All runs together: 30 forecasts of 0.9 of which 27, 24 and 21 of 30 came true: 0.8.
    result.trace.reliabilityCounts[9] = {30, 27.0, static_cast<std::int64_t>(27 - 3 * seed)};
    made.add(result);
  }
  const auto cells = made.cells();
  ASSERT_EQ(cells.size(), 1U);
  const auto figure = [&](const char* name) { return beliefMetric(name).compute(cells[0].runs); };
  EXPECT_NEAR(figure("coverage95_percent"), 89.0, 1e-9);
  EXPECT_EQ(figure("nees"), 5.0);
  EXPECT_NEAR(figure("sure_and_wrong_percent"), 1.0, 1e-12);
  EXPECT_NEAR(figure("existence_ece"), 0.1, 1e-9);
  EXPECT_TRUE(std::isnan(figure("coverage50_percent"))) << "no run has it";
}

TEST(BeliefMetrics, OfTiesAreOfTheScenariosThatHaveThem) {
  MadeResults made;
  made.add(resultOf("S0-slow", Grade::Room, "dewpoint"));
  SuiteResult even = resultOf("S19-even-start", Grade::Room, "dewpoint");
  even.row.confidentInTiePercent = 12.0;
  made.add(even);
  const auto cells = made.cells();
  const auto summaries = summarizeBelief(cells);
  ASSERT_EQ(summaries.size(), 1U);
  const auto figures = beliefMetrics();
  const auto tie = std::ranges::find_if(figures, [](const BeliefMetric& metric) {
    return std::string(metric.name) == "sure_of_tie_percent";
  });
  ASSERT_NE(tie, figures.end());
  const ScenarioSummary& found =
      summaries[0].metricSummaries[static_cast<std::size_t>(tie - figures.begin())];
  EXPECT_EQ(found.medianValue, 12.0) << "the other scenario has no tie";
  EXPECT_EQ(found.worstScenario, "S19-even-start");
}

TEST(BeliefSummary, IsOneForEachGradeAndMethod) {
  MadeResults made;
  for (const std::string scenario : {"S0-slow", "S4-desk-cloud"}) {
    for (const Grade grade : {Grade::Ideal, Grade::Room}) {
      for (const std::string method : {"dewpoint", "triangulation"}) {
        SuiteResult result = resultOf(scenario, grade, method);
        result.row.coverage95Percent = (scenario == "S0-slow" ? 66.0 : 14.0) +
                                       (grade == Grade::Ideal ? 30.0 : 0.0) +
                                       (method == "dewpoint" ? 0.0 : 1.0);
        made.add(result);
      }
    }
  }
  const auto cells = made.cells();
  const auto summaries = summarizeBelief(cells);
  ASSERT_EQ(summaries.size(), 4U);
  EXPECT_EQ(summaries[0].grade, Grade::Ideal);
  EXPECT_EQ(summaries[1].grade, Grade::Ideal);
  const BeliefSummary& room = summaries[2];
  EXPECT_EQ(room.grade, Grade::Room);
  EXPECT_EQ(room.method, "dewpoint");
  EXPECT_EQ(room.scenarioCount, 2U);
  EXPECT_EQ(room.runCount, 2U);
  ASSERT_EQ(room.metricSummaries.size(), beliefMetrics().size());
  EXPECT_EQ(room.metricSummaries[1].medianValue, 40.0) << "of 66 and 14";
  EXPECT_EQ(room.metricSummaries[1].worstValue, 14.0);
  EXPECT_EQ(room.metricSummaries[1].worstScenario, "S4-desk-cloud");
  EXPECT_TRUE(summarizeBelief({}).empty());
}

} // namespace
} // namespace dewpoint::tests
