// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_report.h"
#include "tests/capture/temporary_folder.h"
#include "tests/experiment/suite/suite_results.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace dewpoint::tests {
namespace {

/// Three scenarios of grade room, of which one has 46 % inside the 95 % ellipsoid.
MadeResults roomResults() {
  MadeResults made;
  const std::pair<const char*, double> covered[] = {
      {"S0-slow", 95.0}, {"S4-desk-cloud", 46.0}, {"S9-bump", 94.0}};
  for (const auto& [scenario, percent] : covered) {
    SuiteResult result = resultOf(scenario, Grade::Room, "dewpoint", kFirstReportingSeed);
    result.row.coverage95Percent = percent;
    made.add(result);
  }
  return made;
}

class SuiteReportFiles : public ::testing::Test {
protected:
  void SetUp() override {
    const MadeResults made = roomResults();
    ASSERT_TRUE(writeSuiteReport(folder_ / "", made.results, made.order, {}).has_value());
  }
  std::string file(const std::string& name) const { return contents(folder_ / name); }

private:
  test::TemporaryFolder folder_;
};

TEST_F(SuiteReportFiles, NameMedianAndWorstScenario) {
  EXPECT_NE(file("belief.csv").find("room,dewpoint,3,3,coverage95_percent,94,46,S4-desk-cloud\n"),
            std::string::npos)
      << file("belief.csv");
  EXPECT_NE(file("belief.csv").find("room,dewpoint,3,3,coverage50_percent,,,\n"), std::string::npos)
      << "no run has it";
}

TEST_F(SuiteReportFiles, TellGradeAimAndShortfallOfEachBar) {
  const auto json = nlohmann::json::parse(file("report.json"));
  const auto& figure = json["belief"][0]["figures"]["coverage95_percent"];
  EXPECT_EQ(figure["median"], 94.0);
  EXPECT_EQ(figure["worst"], 46.0);
  EXPECT_EQ(figure["worst_scenario"], "S4-desk-cloud");
  bool found = false;
  for (const auto& bar : json["bars"]) {
    if (bar["grade"] == "room" &&
        bar["requirement"] == "Truth inside the stated 95 % ellipsoid, worst scenario") {
      found = true;
      EXPECT_EQ(bar["next_version"], true);
      EXPECT_EQ(bar["verdict"], "not reached");
      EXPECT_EQ(bar["scenario"], "S4-desk-cloud");
      EXPECT_EQ(bar["shortfall"], 34.0);
      EXPECT_EQ(bar["low"], 80.0);
      EXPECT_EQ(bar["high"], "inf");
    }
  }
  EXPECT_TRUE(found);
}

TEST_F(SuiteReportFiles, HaveNoSectionOfSizesWithoutAny) {
  EXPECT_EQ(file("report.html").find("id='extents'"), std::string::npos);
}

TEST(SuiteReport, ShowsErrorsByTheTargetsSize) {
  MadeResults made;
  SuiteResult ours = resultOf("S21-cap", Grade::Room, "dewpoint", kFirstReportingSeed);
  ours.row.nearCentroidPercent = 83.0;
  ours.row.centroidErrorPercent = 12.0;
  ours.row.sizeErrorPercent = 31.0;
  ours.row.jitterMm = 1.5;
  made.add(ours);
  SuiteResult other = resultOf("S21-cap", Grade::Room, "triangulation", kFirstReportingSeed);
  other.row.nearCentroidPercent = 74.0;
  made.add(other);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeSuiteReport(folder / "", made.results, made.order, {}).has_value());
  const std::string page = contents(folder / "report.html");
  for (const char* const text :
       {"id='extents'", "<td>83<small>radius off by 31 %</small></td>", "<td>74</td>",
        "jitter<br>mm", "near the<br>centroid %", "error of<br>radius %"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  const std::string rows = contents(folder / "summary.csv");
  for (const char* const column :
       {"median_jitter_mm", "median_near_centroid_percent", "median_centroid_error_percent",
        "median_size_error_percent", "median_sure_of_tie_percent"}) {
    EXPECT_NE(rows.find(column), std::string::npos) << column;
  }
}

TEST_F(SuiteReportFiles, ShowItOnThePage) {
  const std::string page = file("report.html");
  for (const char* const text :
       {"<h3>Grade ideal</h3>", "<h3>Grade room</h3>", "<h3>Grade wild</h3>", "next version",
        "≥ 80 %", "✗ by 34 %", "46<br><small>S4-desk-cloud</small>",
        "94<br><small>46 in S4-desk-cloud</small>"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

} // namespace
} // namespace dewpoint::tests
