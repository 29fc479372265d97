// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

SuiteRow sampleRow() {
  SuiteRow row;
  row.key = {"S0-slow", Grade::Room, "barrera", 1000007};
  row.rmseMm = 1.25;
  row.framesToConverge = std::numeric_limits<double>::infinity();
  row.nees = std::numeric_limits<double>::quiet_NaN();
  row.frameCount = 300.0;
  return row;
}

TEST(SuiteRow, IsReadBackAsItWasWritten) {
  const std::string text = rowText(sampleRow());
  EXPECT_TRUE(text.starts_with("S0-slow,room,barrera,1000007,1.25,,"));
  const auto row = parseRow(text);
  ASSERT_TRUE(row.has_value());
  EXPECT_EQ(row->key, sampleRow().key);
  EXPECT_EQ(row->rmseMm, 1.25);
  EXPECT_FALSE(row->medianErrorMm.has_value());
  EXPECT_TRUE(std::isinf(*row->framesToConverge));
  EXPECT_FALSE(row->nees.has_value()) << "what is not a number is nothing";
  EXPECT_EQ(rowText(*row), text);
}

TEST(SuiteRow, HasOneFieldPerColumnOfTheHeader) {
  const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
  EXPECT_EQ(commas(rowHeader()), commas(rowText(sampleRow())));
  EXPECT_TRUE(rowHeader().starts_with("scenario,grade,method,seed,rmse_mm,median_mm,p95_mm,"));
}

TEST(SuiteRow, RefusesWhatIsNotWhole) {
  const std::string text = rowText(sampleRow());
  EXPECT_FALSE(parseRow("").has_value());
  EXPECT_FALSE(parseRow(text.substr(0, text.size() - 3)).has_value()) << "without its last number";
  EXPECT_FALSE(parseRow(text.substr(0, text.size() / 2)).has_value());
  EXPECT_FALSE(parseRow("S0-slow,perfect" + text.substr(12)).has_value()) << "no such grade";
}

TEST(SuiteGrades, AreAListOfNames) {
  using Grades = std::vector<Grade>;
  EXPECT_EQ(gradesFromNames({"both"}), (Grades{Grade::Ideal, Grade::Room}));
  EXPECT_EQ(gradesFromNames({"wild", "ideal", "wild"}), (Grades{Grade::Ideal, Grade::Wild}));
  EXPECT_EQ(gradesFromNames({"real", "both"}), (Grades{Grade::Ideal, Grade::Room, Grade::Real}));
  EXPECT_EQ(gradesFromNames({"room"}), (Grades{Grade::Room}));
  EXPECT_FALSE(gradesFromNames({"room", "bright"}).has_value());
  EXPECT_FALSE(gradesFromNames({}).has_value());
  for (const Grade grade : {Grade::Ideal, Grade::Room, Grade::Wild, Grade::Real}) {
    EXPECT_EQ(gradeFromName(gradeName(grade)), grade);
  }
}

TEST(SuiteTrace, IsReadBackAsItWasWritten) {
  SuiteTrace trace;
  trace.key = {"S5-eight", Grade::Ideal, "camshift", 3};
  trace.errorsMm = {{1.234, std::numeric_limits<double>::quiet_NaN(), 0.5}, {10.0, 20.0, 30.0}};
  trace.reliabilityCounts.resize(kReliabilityBins);
  trace.reliabilityCounts[9] = {6, 5.5, 4};
  const std::string text = traceText(trace);
  const auto read = parseTrace(text);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->key, trace.key);
  ASSERT_EQ(read->errorsMm.size(), 2U);
  EXPECT_EQ(read->errorsMm[0][0], 1.234);
  EXPECT_TRUE(std::isnan(read->errorsMm[0][1]));
  EXPECT_EQ(read->errorsMm[1], trace.errorsMm[1]);
  EXPECT_EQ(read->reliabilityCounts[9].count, 6);
  EXPECT_EQ(read->reliabilityCounts[9].probabilitySum, 5.5);
  EXPECT_EQ(read->reliabilityCounts[9].hitCount, 4);
  EXPECT_EQ(traceText(*read), text);
  EXPECT_FALSE(parseTrace(text.substr(0, text.size() - 8)).has_value());
}

} // namespace
} // namespace dewpoint::tests
