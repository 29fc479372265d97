// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"
#include "core/project/project.h"
#include "core/project/project_changes.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/project/loaded_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr const char* kCalibrated = R"(format = 2
name = "calibrated"

[[camera]]
name = "left"
video = "left.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 510.0, 239.5], [0, 0, 1]]
rotation = [0, 0.1, 0]
translation = [1.0, 2.0, 3.0]
[camera.calibrated]
lens = "board"
lens_error = 0.42
lens_of = [500.0, 510.0, 319.5, 239.5]
pose = "wand"
pose_error = 0.0021
pose_of = [1, 2, 3, 0, 0.1, 0]

[calibrated]
scale = "wand"
scale_error = 0.002
floor = "marks"
accuracy = 0.0031
accuracy_outside = 0.0094
length = [1.5, 1.503]
)";

std::string errorField(const std::string& from, const std::string& to) {
  const auto project = load(kCalibrated, from, to);
  EXPECT_FALSE(project) << from << " -> " << to;
  return project ? "" : project.error().field;
}

Camera turnedCamera() {
  Camera camera;
  camera.intrinsics = {640, 480, 500.0, 510.0, 319.5, 239.5};
  camera.cameraFromWorld.linear() = rotationFromVector({0.3, -1.2, 0.7});
  camera.cameraFromWorld.translation() = Eigen::Vector3d(0.1, -2.0, 3.0);
  return camera;
}

TEST(ProjectRecords, SayWhereACalibrationComesFrom) {
  const auto project = load(kCalibrated);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const CameraRecord& camera = project->cameras.at(0).calibrationRecord;
  ASSERT_TRUE(camera.lens && camera.pose);
  EXPECT_EQ(camera.lens->origin, CalibrationOrigin::Board);
  EXPECT_EQ(camera.lens->error, 0.42);
  EXPECT_TRUE(describes(*camera.lens, project->cameras[0].camera));
  EXPECT_EQ(camera.pose->origin, CalibrationOrigin::Wand);
  EXPECT_EQ(camera.pose->error, 0.0021);
  EXPECT_EQ(project->worldRecord.scaleOrigin, CalibrationOrigin::Wand);
  EXPECT_EQ(project->worldRecord.scaleError, 0.002);
  EXPECT_EQ(project->worldRecord.floorOrigin, CalibrationOrigin::Marks);
  EXPECT_EQ(project->worldRecord.errorInsideVolume, 0.0031);
  EXPECT_EQ(project->worldRecord.errorOutsideVolume, 0.0094);
  EXPECT_EQ(project->worldRecord.lengthCheck, (LengthCheck{1.5, 1.503}));
}

TEST(ProjectRecords, ComeBackFromAFile) {
  auto project = load(kCalibrated);
  ASSERT_TRUE(project);
  Camera& camera = project->cameras[0].camera;
  const std::string name = camera.name;
  camera = turnedCamera();
  camera.name = name;
  project->cameras[0].calibrationRecord = {
      recordOfLens(camera, CalibrationOrigin::Points),
      recordOfPose(camera, CalibrationOrigin::Board, std::numeric_limits<double>::quiet_NaN())};
  const auto again = load(projectText(*project, project->file.parent_path()));
  ASSERT_TRUE(again) << errorSentence(again.error());
  const CameraRecord& record = again->cameras[0].calibrationRecord;
  ASSERT_TRUE(record.lens && record.pose);
  EXPECT_EQ(record.lens->origin, CalibrationOrigin::Points);
  EXPECT_FALSE(record.lens->error);
  EXPECT_FALSE(record.pose->error); // a file holds no unknown number
  EXPECT_TRUE(describes(*record.lens, again->cameras[0].camera));
  EXPECT_TRUE(describes(*record.pose, again->cameras[0].camera));
  EXPECT_EQ(again->worldRecord, project->worldRecord);
}

TEST(ProjectRecords, AreVoidWhenTheNumbersChange) {
  Camera camera = turnedCamera();
  const LensRecord lens = recordOfLens(camera, CalibrationOrigin::Board, 0.3);
  const PoseRecord pose = recordOfPose(camera, CalibrationOrigin::Board, 0.002);
  EXPECT_TRUE(describes(lens, camera));
  EXPECT_TRUE(describes(pose, camera));
  Camera nudged = camera;
  nudged.cameraFromWorld.translation().x() += 1e-4;
  EXPECT_FALSE(describes(pose, nudged));
  nudged = camera;
  nudged.cameraFromWorld.linear() =
      rotationFromVector({0.0, 1e-5, 0.0}) * camera.cameraFromWorld.linear();
  nudged.cameraFromWorld.translation() = -(nudged.cameraFromWorld.linear() * camera.center());
  EXPECT_FALSE(describes(pose, nudged)); // turned about its own center
  EXPECT_TRUE(describes(lens, nudged));
  camera.intrinsics.focalX += 0.01;
  EXPECT_FALSE(describes(lens, camera));
}

TEST(ProjectRecords, AreEditsButNoOtherCalibration) {
  const auto project = load(kCalibrated);
  ASSERT_TRUE(project);
  Project other = *project;
  other.worldRecord.lengthCheck.reset();
  EXPECT_TRUE(changesBetween(*project, other).hasAny());
  EXPECT_FALSE(changesBetween(*project, other).calibrationChanged);
  other = *project;
  other.cameras[0].calibrationRecord.pose.reset();
  EXPECT_TRUE(changesBetween(*project, other).recordsChanged);
  EXPECT_FALSE(changesBetween(*project, other).calibrationChanged);
}

TEST(ProjectRecords, NameTheFieldThatIsWrong) {
  EXPECT_EQ(errorField("lens = \"board\"", "lens = \"paper\""), "camera 1.calibrated.lens");
  EXPECT_EQ(errorField("lens_of = [500.0, 510.0, 319.5, 239.5]", "lens_of = [1]"),
            "camera 1.calibrated.lens_of");
  EXPECT_EQ(errorField("lens_of = [500.0, 510.0, 319.5, 239.5]\n", ""),
            "camera 1.calibrated.lens_of");
  EXPECT_EQ(errorField("pose_error = 0.0021", "pose_error = -1"), "camera 1.calibrated.pose_error");
  EXPECT_EQ(errorField("pose_of = [1, 2, 3, 0, 0.1, 0]", "pose_of = [1, 2, 3, 0, nan, 0]"),
            "camera 1.calibrated.pose_of");
  EXPECT_EQ(errorField("floor = \"marks\"", "floor = 3"), "calibrated.floor");
  EXPECT_EQ(errorField("accuracy = 0.0031", "acuracy = 0.0031"), "calibrated.acuracy");
  EXPECT_EQ(errorField("length = [1.5, 1.503]", "length = [1.5]"), "calibrated.length");
}

} // namespace
} // namespace dewpoint::tests
