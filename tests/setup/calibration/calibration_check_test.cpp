// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/setup/calibration/calibration_check.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class CalibrationCheckTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "calibration-check" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  fs::path write(const char* name, const char* text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  fs::path folder_;
};

TEST_F(CalibrationCheckTest, OfAGoodFileAreTheFormatAndTheCameras) {
  CameraRig rig(2);
  rig[0].name = "left";
  rig[1].name = "right";
  for (Camera& camera : rig) {
    camera.intrinsics = {64, 48, 100.0, 100.0, 31.5, 23.5};
  }
  rig[1].cameraFromWorld.translation().x() = 0.5;
  const fs::path file = folder_ / "calibration.toml";
  ASSERT_TRUE(saveCalibration(rig, file));
  const CheckedCalibration checked = checkCalibration(file);
  EXPECT_FALSE(checked.problem);
  EXPECT_EQ(checked.formatTitle, "Dewpoint");
  EXPECT_EQ(checked.cameras, (std::vector<std::string>{"left", "right"}));
}

TEST_F(CalibrationCheckTest, WhatIsOfNoKnownFormatHasNoTitle) {
  const CheckedCalibration checked = checkCalibration(write("other.json", "{\"K\": [1, 2, 3]}"));
  EXPECT_TRUE(checked.formatTitle.empty());
  ASSERT_TRUE(checked.problem);
  EXPECT_EQ(checked.problem->code, ErrorCode::NotParsed);
  const CheckedCalibration missing = checkCalibration(folder_ / "nowhere.toml");
  ASSERT_TRUE(missing.problem);
  EXPECT_EQ(missing.problem->code, ErrorCode::FileMissing);
}

// Anipose does not write the unit of its lengths: import asks for it.
TEST_F(CalibrationCheckTest, AFileThatLeavesSomethingOpenIsRecognizedAllTheSame) {
  const CheckedCalibration checked = checkCalibration(
      write("anipose.toml", "[cam_0]\nname = \"a\"\nsize = [64, 48]\n"
                            "matrix = [[50.0, 0.0, 32.0], [0.0, 50.0, 24.0], [0.0, 0.0, 1.0]]\n"
                            "distortions = [0.0, 0.0, 0.0, 0.0, 0.0]\n"
                            "rotation = [0.0, 0.0, 0.0]\ntranslation = [0.0, 0.0, 900.0]\n"
                            "[cam_1]\nname = \"b\"\nsize = [64, 48]\n"
                            "matrix = [[50.0, 0.0, 32.0], [0.0, 50.0, 24.0], [0.0, 0.0, 1.0]]\n"
                            "distortions = [0.0, 0.0, 0.0, 0.0, 0.0]\n"
                            "rotation = [0.0, 0.5, 0.0]\ntranslation = [300.0, 0.0, 900.0]\n"
                            "[metadata]\nadjusted = true\nerror = 0.4\n"));
  EXPECT_FALSE(checked.formatTitle.empty());
  ASSERT_TRUE(checked.problem);
  EXPECT_TRUE(checked.needsInput);
}

/// A folder with recordings "left.mkv" and "right.mkv", whose content does not matter.
class CalibrationBesideTest : public CalibrationCheckTest {
protected:
  void SetUp() override {
    CalibrationCheckTest::SetUp();
    for (const auto& old : fs::directory_iterator(folder_)) {
      fs::remove_all(old.path());
    }
    write("left.mkv", "");
    write("right.mkv", "");
  }
  void calibrate(const char* name, const std::vector<std::string>& cameras) const {
    CameraRig rig(cameras.size());
    for (std::size_t k = 0; k < rig.size(); ++k) {
      rig[k].name = cameras[k];
      rig[k].intrinsics = {64, 48, 100.0, 100.0, 31.5, 23.5};
      rig[k].cameraFromWorld.translation().x() = 0.5 * static_cast<double>(k);
    }
    ASSERT_TRUE(saveCalibration(rig, folder_ / name));
  }
  std::optional<fs::path> found() const {
    return calibrationFileBeside(
        {(folder_ / "left.mkv").string(), (folder_ / "right.mkv").string()}, {"left", "right"});
  }
};

TEST_F(CalibrationBesideTest, IsTheOnlyOneThatFits) {
  EXPECT_FALSE(found());
  write("notes.json", "{\"K\": [1, 2, 3]}");
  calibrate("three.toml", {"a", "b", "c"});
  EXPECT_FALSE(found());
  calibrate("calibration.toml", {"cam_0", "cam_1"}); // by order
  EXPECT_EQ(found(), folder_ / "calibration.toml");
  calibrate("older.toml", {"one", "two"});
  EXPECT_FALSE(found()); // nobody knows which
  calibrate("named.toml", {"right", "left"});
  EXPECT_EQ(found(), folder_ / "named.toml");
}

TEST_F(CalibrationBesideTest, IsNoProject) {
  calibrate("calibration.toml", {"left", "right"});
  std::string text = *readTextFile(folder_ / "calibration.toml");
  write("project.toml", ("format = 2\nname = \"mine\"\n" + text).c_str());
  EXPECT_EQ(found(), folder_ / "calibration.toml");
}

TEST_F(CalibrationBesideTest, IsNotLookedForAmongTooManyFiles) {
  calibrate("calibration.toml", {"left", "right"});
  for (int k = 0; k < 64; ++k) {
    write(("pose-" + std::to_string(k) + ".json").c_str(), "{}");
  }
  EXPECT_FALSE(found());
}

TEST_F(CalibrationBesideTest, IsNotLookedForBesideDevicesAndStreams) {
  EXPECT_FALSE(
      calibrationFileBeside({"/dev/video0", "rtsp://camera.example/1"}, {"left", "right"}));
}

TEST(MatchCameras, IsByNameElseByOrderElseNotAtAll) {
  EXPECT_EQ(matchCameras({"left", "right"}, {"right", "top", "left"}), CameraMatch::ByName);
  EXPECT_EQ(matchCameras({"left", "right"}, {"cam_0", "cam_1"}), CameraMatch::ByOrder);
  EXPECT_EQ(matchCameras({"left", "right"}, {"cam_0"}), CameraMatch::None);
  EXPECT_EQ(matchCameras({"left", "right"}, {"left", "cam_1"}), CameraMatch::None);
}

} // namespace
} // namespace dewpoint::tests
