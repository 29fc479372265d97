// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/selftest/self_test.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

SelfTestInputs partsWithoutAScene() {
  SelfTestInputs parts;
  parts.scratchFolder = std::filesystem::path(testing::TempDir()) / "self-test-scratch";
  return parts;
}

SelfTestLine lineOf(const std::vector<SelfTestLine>& lines, const std::string& subject) {
  const auto line = std::ranges::find(lines, subject, &SelfTestLine::subject);
  EXPECT_NE(line, lines.end()) << subject;
  return line != lines.end() ? *line : SelfTestLine();
}

TEST(SelfTest, NamesVersionsAndLeavesNothingBehind) {
  const SelfTestInputs parts = partsWithoutAScene();
  const auto lines = runSelfTest(parts);
  EXPECT_NE(lineOf(lines, "versions").text.find(DEWPOINT_VERSION), std::string::npos);
  EXPECT_EQ(lineOf(lines, "codec FFV1").level, FindingLevel::Ok);
  EXPECT_EQ(lineOf(lines, "cameras").level, FindingLevel::Note);
  EXPECT_FALSE(std::filesystem::exists(parts.scratchFolder));
}

TEST(SelfTest, ADiskThatCannotBeWrittenToIsAProblem) {
  SelfTestInputs parts = partsWithoutAScene();
  parts.scratchFolder = "/proc/nowhere";
  const auto lines = runSelfTest(parts);
  EXPECT_EQ(lineOf(lines, "disk").level, FindingLevel::Problem);
  EXPECT_EQ(worstLevelOf(lines), FindingLevel::Problem);
}

TEST(SelfTest, ACameraThatMayNotBeOpenedIsAProblem) {
  SelfTestInputs parts = partsWithoutAScene();
  parts.cameraNames = {"/dev/video-that-is-not-there"};
  EXPECT_EQ(lineOf(runSelfTest(parts), "camera /dev/video-that-is-not-there").level,
            FindingLevel::Problem);
}

TEST(SelfTest, ASceneThatDoesNotOpenIsAProblem) {
  SelfTestInputs parts = partsWithoutAScene();
  parts.openScene = []() -> Result<SessionInputs> {
    return failure(ErrorCode::NotFound, "demo", "", "");
  };
  EXPECT_EQ(lineOf(runSelfTest(parts), "tracking").level, FindingLevel::Problem);
}

TEST(SelfTest, EndsWhenItIsNotWantedAnyMore) {
  SelfTestInputs parts = partsWithoutAScene();
  parts.shouldContinue = [] { return false; };
  EXPECT_TRUE(runSelfTest(parts).empty());
}

TEST(SelfTest, ALineSaysHowItWent) {
  EXPECT_EQ(selfTestText({FindingLevel::Note, "codec MJPG", "not there"}),
            "note     codec MJPG: not there");
}

} // namespace
} // namespace dewpoint::tests
