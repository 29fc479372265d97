// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/wand_report.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(WandReport, ShowsEveryCameraAndTheTarget) {
  const CameraRig truth = simulated::rig(1, 3);
  WandProblem problem = simulated::wave(truth, 1, 0.2, 150);
  problem.rough = simulated::moved(truth, 0.05, 0.02, 1);
  problem.rough[1].name = "left & <right>";
  problem.scale = WandScale::Stick;
  auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << sentence(result.error());
  result->faults.push_back({CalibrationFault::CameraLate, {1}, 12.0, 99.0, "camera 2 is late"});
  WandReport report;
  report.before = problem.rough;
  report.result = *result;
  report.verdict = "In this volume +-3.1 mm (95 %)";
  report.coverage.resize(3);
  report.offsetsFound = true;
  const std::string html = htmlText(report);
  EXPECT_NE(html.find("<strong>In this volume +-3.1 mm (95 %)</strong>"), std::string::npos);
  EXPECT_NE(html.find("<p class=\"notice\">camera 2 is late</p>"), std::string::npos);
  EXPECT_NE(html.find("<h2>left &amp; &lt;right&gt;</h2>"), std::string::npos);
  EXPECT_NE(html.find("<th>late ms</th>"), std::string::npos);
  // Per camera residuals and coverage; two views of the space.
  EXPECT_EQ(count(html, "aria-label=\"residuals\""), 3U);
  EXPECT_EQ(count(html, "aria-label=\"coverage\""), 3U);
  EXPECT_EQ(count(html, "<svg"), count(html, "</svg>"));
  EXPECT_EQ(count(html, "<svg"), 8U);
  // A stick is a line of two points, in each of the two views once.
  const auto sticks = count(html, "<polyline class=\"board\"");
  EXPECT_GE(sticks, 2U * 30U);
  EXPECT_EQ(sticks % 2, 0U);
  // Residuals are arrows of two strokes each, shaft and head, and no view is without.
  EXPECT_GE(count(html, "M"), 2U * result->problem.observations.size());
}

} // namespace
} // namespace dewpoint::tests
