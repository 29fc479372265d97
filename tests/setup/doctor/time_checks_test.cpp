// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using TimeChecks = ExaminedProject;

TEST_F(TimeChecks, VideosOfDifferentRate) {
  project_.framesPerSecond = 0.0;
  makeVideo(0, 30.0);
  makeVideo(1, 25.0);
  EXPECT_EQ(found(FindingKind::RatesDiffer).placeholderValues[0], "'camera 1' 30, 'camera 2' 25");
}

TEST_F(TimeChecks, TheProjectSaysAnotherRateThanItsVideos) {
  makeVideo(0, 30.0);
  makeVideo(1, 30.0);
  project_.framesPerSecond = 60.0;
  EXPECT_EQ(found(FindingKind::RateOverridden).field, "frames_per_second");
}

TEST_F(TimeChecks, NothingStatesTheRate) {
  project_.framesPerSecond = 0.0;
  EXPECT_EQ(found(FindingKind::RateAssumed).placeholderValues[0], "30");
}

TEST_F(TimeChecks, ATableThatIsNotThere) {
  project_.cameras[0].captureTimeFile = (folder_ / "none.csv").string();
  EXPECT_EQ(found(FindingKind::TimesUnusable).file, project_.cameras[0].captureTimeFile);
  EXPECT_EQ(found(FindingKind::TimesIncomplete).field, "camera 2.times");
}

TEST_F(TimeChecks, ATableOfAnotherRecording) {
  project_.cameras[0].captureTimeFile = text("a.csv", times(0.0, kFrames));
  project_.cameras[1].captureTimeFile = text("b.csv", times(0.0, kFrames - 2));
  EXPECT_EQ(found(FindingKind::TimesCountDiffers).placeholderValues,
            (std::vector<std::string>{"'camera 2'", "10", "12"}));
}

TEST_F(TimeChecks, TablesOfDifferentClocks) {
  project_.cameras[0].captureTimeFile = text("a.csv", times(0.0, kFrames));
  project_.cameras[1].captureTimeFile = text("b.csv", times(1000.0, kFrames));
  found(FindingKind::TimesApart);
}

TEST_F(TimeChecks, TablesThatFitAreFine) {
  project_.framesPerSecond = 0.0;
  project_.cameras[0].captureTimeFile = text("a.csv", times(0.0, kFrames));
  project_.cameras[1].captureTimeFile = text("b.csv", times(0.01, kFrames));
  const auto all = findings();
  EXPECT_EQ(worstLevelOf(all), FindingLevel::Ok) << linesOf(all);
}

TEST_F(TimeChecks, DelaysInMilliseconds) {
  project_.cameras[1].delay = 40.0;
  EXPECT_EQ(found(FindingKind::DelayTooLong).field, "camera 2.late_by");
  project_.cameras[1].captureTimeFile = text("b.csv", times(0.0, kFrames));
  EXPECT_EQ(found(FindingKind::DelayUnusual).placeholderValues[1], "40");
}

} // namespace
} // namespace dewpoint::tests
