// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_report.h"
#include "tests/capture/temporary_folder.h"
#include "tests/experiment/suite/suite_results.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace dewpoint::tests {
namespace {

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

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
