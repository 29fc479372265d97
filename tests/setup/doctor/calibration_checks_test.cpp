// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/new_project.h"
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using CalibrationChecks = ExaminedProject;

TEST_F(CalibrationChecks, ASoundRigIsSaidToBePlausible) {
  EXPECT_EQ(found(FindingKind::CalibrationFine).placeholderValues[0], "2");
}

TEST_F(CalibrationChecks, Millimeters) {
  for (ProjectCamera& camera : project_.cameras) {
    camera.camera.cameraFromWorld.translation() *= 1000.0;
  }
  EXPECT_EQ(found(FindingKind::UnitWrong).placeholderValues[1], "0.001");
}

TEST_F(CalibrationChecks, TwoCamerasOfOnePose) {
  project_.cameras[1].camera.cameraFromWorld = project_.cameras[0].camera.cameraFromWorld;
  EXPECT_EQ(found(FindingKind::SamePose).placeholderValues,
            (std::vector<std::string>{"'camera 1'", "'camera 2'"}));
}

TEST_F(CalibrationChecks, AMatrixOfAnotherResolution) {
  project_.cameras[0].camera.intrinsics.centerX = 960.0;
  found(FindingKind::CalibrationImplausible);
}

TEST_F(CalibrationChecks, ACameraUnderTheFloor) {
  project_.cameras[1].camera.cameraFromWorld = lookAt({1.0, 0.5, -0.4}, {0.0, 0.0, 0.1});
  const Finding finding = found(FindingKind::BelowFloor);
  EXPECT_EQ(finding.placeholderValues, (std::vector<std::string>{"'camera 2'", "0.40"}));
  EXPECT_EQ(finding.level(), FindingLevel::Note);
}

TEST_F(CalibrationChecks, ACameraThatLooksAway) {
  const Eigen::Vector3d at = project_.cameras[1].camera.center();
  project_.cameras[1].camera.cameraFromWorld = lookAt(at, at + Eigen::Vector3d(0.05, 0.1, 1.0));
  found(FindingKind::FacesAway);
}

TEST_F(CalibrationChecks, AGuessIsNoCalibration) {
  NewProject wanted;
  for (const ProjectCamera& camera : project_.cameras) {
    wanted.cameras.push_back({"", SourceKind::Images, camera.location});
  }
  Project guessed = createNewProject(wanted)->project;
  guessed.file = project_.file;
  guessed.targets = project_.targets;
  project_ = guessed;
  found(FindingKind::CalibrationGuessed);
}

TEST_F(CalibrationChecks, MethodsThatFollowBoxesNeedNone) {
  project_.method = "histogram";
  project_.cameras[1].camera.cameraFromWorld = project_.cameras[0].camera.cameraFromWorld;
  for (const Finding& finding : findings()) {
    EXPECT_NE(finding.kind, FindingKind::SamePose);
  }
}

} // namespace
} // namespace dewpoint::tests
