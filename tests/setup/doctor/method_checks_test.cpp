// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using MethodChecks = ExaminedProject;

TEST_F(MethodChecks, AMethodThatFits) {
  EXPECT_EQ(found(FindingKind::MethodFits).placeholderValues[0], "dewpoint");
}

TEST_F(MethodChecks, TooFewCameras) {
  project_.method = "dynamics";
  project_.cameras.pop_back();
  EXPECT_EQ(found(FindingKind::NeedsMoreCameras).placeholderValues,
            (std::vector<std::string>{"dynamics", "2", "1"}));
}

TEST_F(MethodChecks, AMethodThatNeedsToKnowWhereTheCamerasAre) {
  project_.cameras[1].camera.intrinsics.width = 0;
  EXPECT_EQ(found(FindingKind::NeedsCalibration).field, "method");
}

TEST_F(MethodChecks, AVolumeThatNobodySees) {
  project_.volumeOfInterest = WorldBox{{-0.3, -0.3, 0.0}, {0.3, 0.3, 0.4}};
  const auto seen = findings();
  EXPECT_EQ(worstLevelOf(seen), FindingLevel::Ok) << linesOf(seen);
  project_.volumeOfInterest = WorldBox{{30.0, 30.0, 30.0}, {31.0, 31.0, 31.0}};
  EXPECT_EQ(found(FindingKind::VolumeOutOfView).placeholderValues[0], "2");
}

TEST_F(MethodChecks, CorrectionsOfAnotherRecording) {
  PositionCorrection correction;
  correction.frame = 400;
  project_.corrections.push_back(correction);
  EXPECT_EQ(found(FindingKind::CorrectionTooLate).placeholderValues[0], "1");
}

TEST_F(MethodChecks, ATruthThatCannotBeRead) {
  project_.truthFile = text("truth.csv", "what,is,this\n1,2,3\n");
  EXPECT_EQ(found(FindingKind::TruthUnusable).file, project_.truthFile->string());
}

} // namespace
} // namespace dewpoint::tests
