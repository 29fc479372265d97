// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_check.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// A folder with two image folders, "left" and "right", of one 64x48 image each.
class NewProjectTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    for (const char* name : {"left", "right"}) {
      fs::create_directories(folder_ / name);
      cv::imwrite((folder_ / name / "0.png").string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(0)));
    }
  }

  NewProject two() const {
    NewProject wanted;
    wanted.cameras = {{"", SourceKind::Images, (folder_ / "left").string()},
                      {"", SourceKind::Images, (folder_ / "right").string()}};
    return wanted;
  }

  /// Writes a calibration with these names, told apart by their focal lengths 100, 101, ...
  fs::path calibration(const std::vector<std::string>& names) const {
    CameraRig rig;
    for (const auto& name : names) {
      Camera camera;
      camera.name = name;
      const double focal = 100.0 + static_cast<double>(rig.size());
      camera.intrinsics = {64, 48, focal, focal, 31.5, 23.5};
      rig.push_back(camera);
    }
    const fs::path file = folder_ / "calibration.toml";
    EXPECT_TRUE(saveCalibration(rig, file));
    return file;
  }

  fs::path folder_;
};

TEST_F(NewProjectTest, CamerasAreCalledAsTheirFiles) {
  const auto made = createNewProject(two());
  ASSERT_TRUE(made) << errorSentence(made.error());
  const Project& project = made->project;
  EXPECT_EQ(project.name, folder_.filename());
  ASSERT_EQ(project.cameras.size(), 2U);
  EXPECT_EQ(project.cameras[0].camera.name, "left");
  EXPECT_EQ(project.cameras[1].camera.name, "right");
  EXPECT_TRUE(project.targets.empty());
  EXPECT_TRUE(checkProject(project));
}

TEST_F(NewProjectTest, WithoutACalibrationSizesAreReadAndPosesDiffer) {
  const auto made = createNewProject(two());
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->lacksCalibration);
  const auto& cameras = made->project.cameras;
  EXPECT_EQ(cameras[0].camera.intrinsics.width, 64);
  EXPECT_EQ(cameras[0].camera.intrinsics.height, 48);
  EXPECT_GT((cameras[0].camera.center() - cameras[1].camera.center()).norm(), 1.0);
}

// A project of one camera in a file: no more than the size of its images is needed.
TEST_F(NewProjectTest, MissingCalibrationsAreGuessedFromTheImages) {
  auto made = createNewProject(two());
  ASSERT_TRUE(made);
  Project project = made->project;
  EXPECT_TRUE(hasGuessedPose(project));
  const Camera whole = project.cameras[1].camera;
  project.cameras[1].camera.intrinsics = {};
  project.cameras[1].camera.cameraFromWorld = Eigen::Isometry3d::Identity();
  ASSERT_TRUE(guessMissingCameras(project));
  EXPECT_EQ(project.cameras[1].camera, whole);
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.cameraFromWorld.translation().z() += 0.5;
  }
  EXPECT_FALSE(hasGuessedPose(project));
}

TEST_F(NewProjectTest, OneCameraWithoutACalibrationFollowsBoxes) {
  NewProject one = two();
  one.cameras.resize(1);
  const auto made = createNewProject(one);
  ASSERT_TRUE(made);
  EXPECT_EQ(methodFamily(made->project.method).targetSource, TargetSource::Box);
  EXPECT_FALSE(made->lacksCalibration);
  EXPECT_EQ(made->project.name, "left"); // one recording says nothing of its folder
  EXPECT_TRUE(checkParameters(made->project.method, made->project.parameters));
  EXPECT_EQ(createNewProject(two())->project.method, "dewpoint");
}

TEST_F(NewProjectTest, CalibrationsGoByName) {
  auto wanted = two();
  wanted.calibrationFile = calibration({"right", "other", "left"});
  const auto made = createNewProject(wanted);
  ASSERT_TRUE(made) << errorSentence(made.error());
  EXPECT_FALSE(made->lacksCalibration);
  EXPECT_FALSE(made->wereCamerasMatchedByOrder);
  EXPECT_EQ(made->project.cameras[0].camera.intrinsics.focalX, 102.0); // the third of the file
  EXPECT_EQ(made->project.cameras[1].camera.intrinsics.focalX, 100.0); // the first
}

TEST_F(NewProjectTest, OrElseByOrderWhichIsSaid) {
  auto wanted = two();
  wanted.calibrationFile = calibration({"cam_0", "cam_1"});
  const auto made = createNewProject(wanted);
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->wereCamerasMatchedByOrder);
  EXPECT_EQ(made->project.cameras[1].camera.intrinsics.focalX, 101.0);
  EXPECT_EQ(made->project.cameras[1].camera.name, "right");
}

TEST_F(NewProjectTest, ACalibrationThatFitsNeitherWayIsRefused) {
  auto wanted = two();
  wanted.calibrationFile = calibration({"left", "other"});
  const auto made = createNewProject(wanted);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::Mismatch);
  EXPECT_NE(made.error().detail.find("'left', 'other'"), std::string::npos) << made.error().detail;
  EXPECT_NE(made.error().detail.find("'left', 'right'"), std::string::npos) << made.error().detail;
  wanted.adaptation.cameraRenaming = {{"right", "other"}};
  const auto mapped = createNewProject(wanted);
  ASSERT_TRUE(mapped) << errorSentence(mapped.error());
  EXPECT_FALSE(mapped->wereCamerasMatchedByOrder);
  EXPECT_EQ(mapped->project.cameras[1].camera.name, "right");
  EXPECT_EQ(mapped->project.cameras[1].camera.intrinsics.focalX, 101.0);
}

TEST_F(NewProjectTest, ACalibrationOfAnotherImageSizeIsFittedAsTheUserSays) {
  for (const char* name : {"left", "right"}) { // 64x48 is calibrated
    cv::imwrite((folder_ / name / "0.png").string(), cv::Mat(40, 64, CV_8UC3, cv::Scalar(0)));
  }
  auto wanted = two();
  wanted.calibrationFile = calibration({"left", "right"});
  const auto refused = createNewProject(wanted);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Mismatch);
  EXPECT_EQ(refused.error().field, "left");
  EXPECT_NE(refused.error().detail.find("64 x 48"), std::string::npos);
  EXPECT_NE(refused.error().detail.find("64 x 40"), std::string::npos);
  wanted.adaptation.sizeFit = SizeFit::Crop;
  const auto made = createNewProject(wanted);
  ASSERT_TRUE(made) << errorSentence(made.error());
  EXPECT_EQ(made->decisions.size(), 2U);
  const Intrinsics& in = made->project.cameras[1].camera.intrinsics;
  EXPECT_EQ(in.height, 40);
  EXPECT_DOUBLE_EQ(in.centerY, 19.5);
  wanted.adaptation.sizeFit = SizeFit::Rotate90;
  EXPECT_EQ(createNewProject(wanted).error().code, ErrorCode::Mismatch); // 48 x 64 then
}

TEST_F(NewProjectTest, TheSameNameTwiceIsMadeDifferent) {
  auto wanted = two();
  wanted.cameras[1].name = "left";
  const auto made = createNewProject(wanted);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->project.cameras[1].camera.name, "left 2");
}

TEST_F(NewProjectTest, BadInputNamesTheCamera) {
  auto wanted = two();
  wanted.cameras[1].location = (folder_ / "nowhere.mp4").string();
  wanted.cameras[1].sourceKind = SourceKind::Video;
  const auto missing = createNewProject(wanted);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileMissing);
  EXPECT_EQ(missing.error().field, "nowhere");
  EXPECT_FALSE(createNewProject({}));
}

TEST_F(NewProjectTest, ItIsProposedToBeSavedBesideItsFirstRecording) {
  auto made = createNewProject(two());
  ASSERT_TRUE(made);
  EXPECT_EQ(proposedProjectFile(made->project), folder_ / (made->project.name + ".toml"));
  made->project.name = "a/b";
  EXPECT_EQ(proposedProjectFile(made->project), folder_ / "a_b.toml");
  for (ProjectCamera& camera : made->project.cameras) {
    camera.source = SourceKind::Device;
  }
  EXPECT_EQ(proposedProjectFile(made->project), "a_b.toml");
  EXPECT_EQ(proposedProjectFile({}), "project.toml");
}

TEST(GuessedSource, GoesByWhatTheTextLooksLike) {
  EXPECT_EQ(guessSourceKind("0"), SourceKind::Device);
  EXPECT_EQ(guessSourceKind("/dev/video2"), SourceKind::Device);
  EXPECT_EQ(guessSourceKind("http://camera.local/video"), SourceKind::Stream);
  EXPECT_EQ(guessSourceKind("gst:videotestsrc ! appsink"), SourceKind::Stream);
  EXPECT_EQ(guessSourceKind("test:ball"), SourceKind::Stream);
  EXPECT_EQ(guessSourceKind("left.mp4"), SourceKind::Video);
  EXPECT_EQ(guessSourceKind(testing::TempDir()), SourceKind::Images);
}

} // namespace
} // namespace dewpoint::tests
