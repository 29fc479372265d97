// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/calibration/calibration_exchange.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

const std::filesystem::path kGolden = DEWPOINT_SOURCE_DIR "/tests/calibration/golden";

class CalibrationExchange : public testing::Test {
protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(testing::TempDir()) /
        ("exchange-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  Project project_ = test::twoCameraProject();
  std::filesystem::path folder_;
};

TEST_F(CalibrationExchange, WhatIsExportedIsImportedAgain) {
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write == nullptr) {
      continue;
    }
    SCOPED_TRACE(format.name);
    CalibrationOutput target;
    target.format = format.name;
    target.path = folder_ / (std::string("out-") + format.name +
                             (format.layout == FileLayout::OneFile ? format.extension : ""));
    const auto preview = previewExport(project_, target);
    ASSERT_TRUE(preview) << errorSentence(preview.error());
    EXPECT_FALSE(std::filesystem::exists(target.path)) << "a preview leaves no file";
    const auto written = exportCalibration(project_, target);
    ASSERT_TRUE(written) << errorSentence(written.error());
    EXPECT_EQ(written->maxDifferencePx, preview->maxDifferencePx);
    EXPECT_LT(written->maxDifferencePx, 1e-6); // a pinhole without distortion fits every format
    EXPECT_FALSE(written->writtenFiles.empty());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "preview"));
  }
}

TEST_F(CalibrationExchange, ImportMatchesByNameAndSaysWhatChanges) {
  CameraRig rig = rigOf(project_);
  // The right camera 0.25 m higher, and the file in the other order.
  rig[1].cameraFromWorld.translation() -=
      rig[1].cameraFromWorld.linear() * Eigen::Vector3d(0, 0, .25);
  std::swap(rig[0], rig[1]);
  CalibrationOutput target;
  target.format = "anipose";
  target.path = folder_ / "calibration.toml";
  ASSERT_TRUE(writeCalibration(rig, target));

  ImportRequest wish{target.path, {}};
  const auto open = importCalibration(project_, wish); // anipose does not say its unit
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().field, "unit");
  const ImportProblem asked = importProblem(open.error());
  EXPECT_EQ(asked.question, ImportQuestion::Unit);
  EXPECT_EQ(asked.error.detail.find("--"), std::string::npos) << asked.error.detail;
  EXPECT_NE(asked.error.detail.find("probably mm"), std::string::npos) << asked.error.detail;
  wish.hints.metersPerUnit = 0.001;
  const auto made = importCalibration(project_, wish);
  ASSERT_TRUE(made) << errorSentence(made.error());
  EXPECT_FALSE(made->wereCamerasMatchedByOrder);
  EXPECT_FALSE(made->hasOnlyIntrinsics);
  EXPECT_LT(made->maxConversionErrorPx, 1e-6);
  ASSERT_EQ(made->cameras.size(), 2U);
  EXPECT_EQ(made->cameras[0].name, "left");
  EXPECT_NEAR(made->cameras[0].poseChange.meters, 0.0, 1e-9);
  EXPECT_NEAR(made->cameras[1].poseChange.meters, 0.25, 1e-9);
  EXPECT_NEAR(made->cameras[1].poseChange.radians, 0.0, 1e-6);
  EXPECT_NEAR(made->project.cameras[1].camera.center().z(),
              project_.cameras[1].camera.center().z() + 0.25, 1e-9);
  EXPECT_FALSE(made->decisions.empty());
}

TEST_F(CalibrationExchange, NamesThatDoNotFitAreAskedForAndMapped) {
  CameraRig rig = rigOf(project_);
  rig[0].name = "right"; // the file has it the other way round, and one more
  rig[1].name = "third";
  rig.push_back(rig[1]);
  rig[2].name = "fourth";
  rig[2].cameraFromWorld.translation().x() += 0.5;
  const auto file = folder_ / "names.toml";
  ASSERT_TRUE(saveCalibration(rig, file));
  ImportRequest wish{file, {}};
  EXPECT_EQ(cameraNamesIn(wish), (std::vector<std::string>{"right", "third", "fourth"}));
  const auto refused = importCalibration(project_, wish);
  ASSERT_FALSE(refused);
  const ImportProblem asked = importProblem(refused.error());
  EXPECT_EQ(asked.question, ImportQuestion::Names);
  EXPECT_EQ(
      asked.error.detail,
      "it has 3 cameras ('right', 'third', 'fourth'), and the project has 2 ('left', 'right')");
  wish.adaptation.cameraRenaming = {{"left", "right"}, {"right", "fourth"}};
  const auto made = importCalibration(project_, wish);
  ASSERT_TRUE(made) << errorSentence(made.error());
  ASSERT_EQ(made->cameras.size(), 2U);
  EXPECT_EQ(made->cameras[0].fileName, "right");
  EXPECT_EQ(made->cameras[1].fileName, "fourth");
  EXPECT_NEAR(made->cameras[0].poseChange.meters, 0.0, 1e-9);
  EXPECT_NEAR(made->cameras[1].poseChange.meters, 0.5, 1e-9);
}

TEST_F(CalibrationExchange, TheSizeOfTheImagesIsAQuestion) {
  const ImportProblem asked = importProblem(
      {ErrorCode::Mismatch, "rig.toml", "left", "64 x 48, and 64 x 40: adapt it with --fit crop"});
  EXPECT_EQ(asked.question, ImportQuestion::Fit);
  EXPECT_EQ(asked.error.detail, "64 x 48, and 64 x 40");
}

TEST_F(CalibrationExchange, TwoCamerasOfOnePoseAreNamed) {
  CameraRig rig = rigOf(project_);
  const auto file = folder_ / "copied.toml";
  ASSERT_TRUE(saveCalibration(rig, file));
  auto made = importCalibration(project_, {file, {}});
  ASSERT_TRUE(made) << errorSentence(made.error());
  EXPECT_TRUE(made->likelyMistakes.empty());
  rig[1].cameraFromWorld = rig[0].cameraFromWorld;
  ASSERT_TRUE(saveCalibration(rig, file));
  made = importCalibration(project_, {file, {}}); // not an error
  ASSERT_TRUE(made) << errorSentence(made.error());
  ASSERT_EQ(made->likelyMistakes.size(), 1U);
  EXPECT_EQ(made->likelyMistakes.front().fault, CameraFault::SamePose);
  EXPECT_EQ(made->likelyMistakes.front().cameras, (std::vector<std::size_t>{0, 1}));
}

TEST_F(CalibrationExchange, AFileOfOneCameraIsForTheOneThatIsNamed) {
  ImportRequest wish{kGolden / "opencv_sample.yml", {}};
  wish.hints.metersPerUnit = 1.0;
  const auto unknown = importCalibration(project_, wish);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().field, "camera");
  wish.camera = 1;
  const auto made = importCalibration(project_, wish);
  ASSERT_TRUE(made) << errorSentence(made.error());
  EXPECT_EQ(made->project.cameras[0].camera, project_.cameras[0].camera);
  EXPECT_NE(made->project.cameras[1].camera.intrinsics.focalX, 150.0);
  EXPECT_EQ(made->project.cameras[1].camera.name, "right");
  ASSERT_EQ(made->cameras.size(), 1U);
  EXPECT_EQ(made->cameras[0].camera, 1U);
  EXPECT_EQ(made->cameras[0].name, "right");
  wish.camera = 2;
  const auto missing = importCalibration(project_, wish);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace dewpoint::tests
