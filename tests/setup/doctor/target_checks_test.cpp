// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using TargetChecks = ExaminedProject;

TEST_F(TargetChecks, AColorThatIsThereIsFine) {
  EXPECT_EQ(found(FindingKind::ColorFine).values[0], "red");
}

TEST_F(TargetChecks, NothingToTrack) {
  project_.targets.clear();
  found(FindingKind::TargetsMissing);
}

TEST_F(TargetChecks, AColorThatWasNeverLearned) {
  project_.targets[0].color = {};
  EXPECT_EQ(found(FindingKind::ColorNotLearned).field, "target 1.hue");
}

TEST_F(TargetChecks, ARangeThatNothingMatches) {
  project_.targets[0].color = {200.0, 200.001, 0.99999, 1.0, 0.9, 0.90001};
  found(FindingKind::ColorMatchesNothing);
}

TEST_F(TargetChecks, AColorOfTheSurroundings) {
  project_.targets[0].color = {0.0, 360.0, 0.0, 1.0, 0.0, 1.0};
  const Finding finding = found(FindingKind::ColorEverywhere);
  EXPECT_EQ(finding.values[2], "'camera 1'");
}

TEST_F(TargetChecks, AColorThatIsNowhere) {
  project_.targets[0].color = {110.0, 130.0, 0.3, 1.0, 0.1, 0.9};
  EXPECT_EQ(found(FindingKind::ColorNowhere).values[1], "6");
}

TEST_F(TargetChecks, AColorThatOneCameraNeverSees) {
  for (int frame = 0; frame < kFrames; ++frame) {
    cv::imwrite(imageFile(1, frame), cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(90)));
  }
  EXPECT_EQ(found(FindingKind::ColorNotInCamera).values[1], "'camera 2'");
}

TEST_F(TargetChecks, ARadiusInMillimeters) {
  project_.targets[0].radius = 35.0;
  EXPECT_EQ(found(FindingKind::RadiusUnlikely).field, "target 1.radius");
}

TEST_F(TargetChecks, BoxesThatAreMissingOrBeyondTheEnd) {
  project_.method = "histogram";
  found(FindingKind::BoxMissing);
  found(FindingKind::TargetsMissing);
  TargetBox box;
  box.box = {100.0, 100.0, 20.0, 20.0};
  box.frame = kFrames;
  project_.targets[0].box = box;
  EXPECT_EQ(found(FindingKind::BoxTooLate).values[1], "12");
}

} // namespace
} // namespace dewpoint::tests
