// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using TargetChecks = ExaminedProject;

TEST_F(TargetChecks, AColorThatIsThereIsFine) {
  EXPECT_EQ(found(FindingKind::ColorFine).placeholderValues[0], "red");
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
  EXPECT_EQ(finding.placeholderValues[2], "'camera 1'");
}

TEST_F(TargetChecks, AColorThatIsNowhere) {
  project_.targets[0].color = {110.0, 130.0, 0.3, 1.0, 0.1, 0.9};
  EXPECT_EQ(found(FindingKind::ColorNowhere).placeholderValues[1], "6");
}

TEST_F(TargetChecks, AColorThatOneCameraNeverSees) {
  for (int frame = 0; frame < kFrames; ++frame) {
    cv::imwrite(imageFile(1, frame), cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(90)));
  }
  EXPECT_EQ(found(FindingKind::ColorNotInCamera).placeholderValues[1], "'camera 2'");
}

TEST_F(TargetChecks, ATargetThatWasOverexposedOrTooDarkWhenItWasLearned) {
  ColorSample bright;
  bright.camera = 1;
  bright.colors = {{40, 30, 255}, {40, 30, 255}, {40, 30, 200}, {40, 30, 180}, {40, 30, 180}};
  ColorSample dark;
  dark.camera = 0;
  dark.colors = {{4, 3, 15}, {4, 3, 12}, {10, 9, 60}};
  ColorSample wall = bright;
  wall.camera = 0;
  wall.isExcluded = true; // it is not the target
  project_.targets[0].samples = {bright, dark, wall};
  const Finding over = found(FindingKind::TargetOverexposed);
  EXPECT_EQ(over.placeholderValues, (std::vector<std::string>{"red", "40", "'camera 2'"}));
  EXPECT_EQ(over.field, "target 1.sample");
  EXPECT_EQ(found(FindingKind::TargetTooDark).placeholderValues,
            (std::vector<std::string>{"red", "67", "'camera 1'"}));
}

TEST_F(TargetChecks, HighlightsAreNoFinding) {
  ColorSample sample;
  sample.colors.assign(10, {40, 30, 180});
  sample.colors[0] = {255, 255, 255};
  project_.targets[0].samples = {sample};
  for (const Finding& finding : findings()) {
    EXPECT_NE(finding.kind, FindingKind::TargetOverexposed);
    EXPECT_NE(finding.kind, FindingKind::TargetTooDark);
  }
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
  EXPECT_EQ(found(FindingKind::BoxTooLate).placeholderValues[1], "12");
}

} // namespace
} // namespace dewpoint::tests
