// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/camera_calibration.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr const char* kGood = R"(
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 510.0, 239.5], [0, 0, 1]]
distortions = [0.1, -0.2, 0.001, 0.002, 0.3]
rotation = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
translation = [1.0, 2.0, 3.0]
)";

Result<Camera> parse(std::string text, const std::string& from = "", const std::string& to = "") {
  if (const auto at = from.empty() ? std::string::npos : text.find(from); at != std::string::npos) {
    text.replace(at, from.size(), to);
  }
  return cameraFromToml(toml::parse(text), "rig.toml", "cam_0.");
}

Error errorOfCamera(const std::string& from, const std::string& to) {
  const auto camera = parse(kGood, from, to);
  EXPECT_FALSE(camera);
  return camera ? Error{} : camera.error();
}

TEST(CameraCalibration, ReadsEveryKey) {
  const auto camera = parse(std::string(kGood) + "unit = 0.03\nname = \"left\"\n");
  ASSERT_TRUE(camera) << errorSentence(camera.error());
  EXPECT_EQ(camera->name, "left");
  EXPECT_EQ(camera->intrinsics.width, 640);
  EXPECT_EQ(camera->intrinsics.focalY, 510.0);
  EXPECT_EQ(camera->distortion[4], 0.3);
  EXPECT_EQ(camera->distortion[5], 0.0);
  // 3 board squares of 0.03 m.
  EXPECT_NEAR(camera->cameraFromWorld.translation().z(), 0.09, 1e-15);
  // The matrix turns +X into +Y.
  EXPECT_NEAR(
      (camera->cameraFromWorld.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY())
          .norm(),
      0.0, 1e-12);
}

TEST(CameraCalibration, ARodriguesVectorIsTheSameRotation) {
  const double quarter = std::numbers::pi / 2; // about +Z: the matrix above
  const auto camera =
      parse(kGood, "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[0, 0, " + std::to_string(quarter) + "]");
  ASSERT_TRUE(camera) << errorSentence(camera.error());
  EXPECT_TRUE(camera->cameraFromWorld.linear().isApprox(parse(kGood)->cameraFromWorld.linear(),
                                                        1e-6)); // std::to_string gives 6 digits
}

TEST(CameraCalibration, NamesTheFileAndTheFieldOfWhatIsWrong) {
  EXPECT_EQ(errorOfCamera("500.0", "nan").field, "cam_0.matrix");
  EXPECT_EQ(errorOfCamera("500.0", "nan").file, "rig.toml");
  EXPECT_EQ(errorOfCamera("500.0", "0.0").field, "cam_0.matrix");
  EXPECT_NE(errorOfCamera("500.0", "0.0").detail.find("focal"), std::string::npos);
  EXPECT_NE(errorOfCamera("[0, -1, 0]", "[0, -2, 0]").detail.find("not a rotation"),
            std::string::npos);
  EXPECT_NE(errorOfCamera("[0, 0, 1]]\ntrans", "[0, 0, -1]]\ntrans").detail.find("mirrors"),
            std::string::npos);
  EXPECT_EQ(errorOfCamera("[1.0, 2.0, 3.0]", "[1.0, inf, 3.0]").field, "cam_0.translation");
  EXPECT_EQ(errorOfCamera("[0.1, -0.2, 0.001, 0.002, 0.3]", "[0.1, 0.2, 0.3]").field,
            "cam_0.distortions");
  EXPECT_EQ(errorOfCamera("size = [640, 480]", "").code, ErrorCode::MissingKey);
  EXPECT_EQ(errorOfCamera("size", "sizes = [1]\nsize").code, ErrorCode::UnknownKey);
}

TEST(CalibrationFile, ComesBackAsItWas) {
  Camera camera = *parse(kGood);
  camera.name = "a \"quoted\" name";
  const auto file = std::filesystem::path(testing::TempDir()) / "calibration_round_trip.toml";
  ASSERT_TRUE(saveCalibration({camera, camera}, file));
  const auto rig = loadCalibration(file);
  ASSERT_TRUE(rig) << errorSentence(rig.error());
  ASSERT_EQ(rig->size(), 2U);
  EXPECT_EQ(rig->front().name, camera.name);
  EXPECT_EQ(rig->front().distortion, camera.distortion);
  EXPECT_TRUE(rig->front().cameraFromWorld.isApprox(camera.cameraFromWorld, 1e-12));
}

TEST(CalibrationFile, SaysThatItIsMissing) {
  const auto rig = loadCalibration("/nowhere/calibration.toml");
  ASSERT_FALSE(rig);
  EXPECT_EQ(rig.error().code, ErrorCode::FileMissing);
}

} // namespace
} // namespace dewpoint::tests
