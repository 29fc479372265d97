// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/wand_report.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// What is between `from` and the next `to` after it; empty where there is no `from`. `text` goes
/// on behind it.
std::string next(std::string& text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from);
  if (begin == std::string::npos) {
    return {};
  }
  const auto end = text.find(to, begin + from.size());
  std::string between = text.substr(begin + from.size(), end - begin - from.size());
  text.erase(0, end);
  return between;
}

TEST(WandReport, ShowsEveryCameraAndTheTarget) {
  const CameraRig truth = simulated::rig(1, 3);
  WandProblem problem = simulated::wave(truth, 1, 0.2, 150);
  problem.initialRig = simulated::moved(truth, 0.05, 0.02, 1);
  problem.initialRig[1].name = "left & <right>";
  problem.scaleMethod = WandScale::Stick;
  auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  // Copied: moving it is a false alarm of g++ 12 about the short text.
  const DetectedFault late{CalibrationFault::CameraDelayed, {1}, 12.0, 99.0, "camera 2 is late"};
  result->faults.push_back(late);
  WandReport report;
  report.initialRig = problem.initialRig;
  report.result = *result;
  report.accuracyText = "In this volume +-3.1 mm (95 %)";
  report.coverage.resize(3);
  report.hasTimeOffsets = true;
  report.notices = {"The ball moved only along one line."};
  const std::string html = htmlText(report);
  EXPECT_NE(html.find("<strong>In this volume +-3.1 mm (95 %)</strong>"), std::string::npos);
  EXPECT_NE(html.find("<p class=\"notice\">camera 2 is late</p>"), std::string::npos);
  EXPECT_NE(html.find("<p class=\"notice\">The ball moved only along one line.</p>"),
            std::string::npos);
  EXPECT_NE(html.find("<h2>left &amp; &lt;right&gt;</h2>"), std::string::npos);
  EXPECT_NE(html.find("<th>delay ms</th>"), std::string::npos);
  // Per camera residuals and coverage; two views of the space.
  EXPECT_EQ(count(html, "aria-label=\"residuals\""), 3U);
  EXPECT_EQ(count(html, "aria-label=\"coverage\""), 3U);
  EXPECT_EQ(count(html, "aria-label=\"cameras and the wand\""), 1U);
  EXPECT_EQ(count(html, "aria-label=\"from above\""), 1U);
  EXPECT_EQ(count(html, "<svg"), count(html, "</svg>"));
  // A stick is a line of two points, in each of the two views once.
  const auto& states = result->bundle.states;
  const auto sticks = std::ranges::count(states, true, &BundleState::isPositionKnown);
  ASSERT_LT(states.size(), 300U); // none is left out of the drawing
  EXPECT_GT(sticks, 30);
  EXPECT_EQ(count(html, "<polyline class=\"board\""), 2U * std::size_t(sticks));
  // An arrow per residual that took part, of two strokes each, shaft and head, in its camera's
  // drawing.
  std::string rest = html;
  for (std::size_t camera = 0; camera < 3; ++camera) {
    std::size_t used = 0;
    for (std::size_t i = 0; i < result->problem.observations.size(); ++i) {
      used += result->problem.observations[i].camera == camera &&
                      result->bundle.residuals[i].allFinite()
                  ? 1
                  : 0;
    }
    ASSERT_GT(used, 60U);
    next(rest, "aria-label=", "\"residuals\"");
    EXPECT_EQ(count(next(rest, "<path class=\"arrow\" d=\"", "\"/>"), "M"), 2U * used) << camera;
  }
}

} // namespace
} // namespace dewpoint::tests
