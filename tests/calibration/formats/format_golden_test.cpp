// SPDX-License-Identifier: GPL-3.0-or-later
// Files of other tools (tests/calibration/golden/make_golden.py says who wrote which, and whose
// pixels these are).
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/calibration_format.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/geometry/projector.h"
#include "tests/calibration/own_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace dewpoint::tests {
namespace {

const std::filesystem::path kGolden =
    std::filesystem::path(DEWPOINT_SOURCE_DIR) / "tests/calibration/golden";

struct Golden {
  const char* format;
  CalibrationHints hints; ///< what the file does not say
};

CalibrationHints unit(double meters) {
  CalibrationHints hints;
  hints.metersPerUnit = meters;
  return hints;
}

CalibrationHints stereo() {
  CalibrationHints hints = unit(0.025); // squares of 25 mm
  hints.imageSize = {1280, 720};
  return hints;
}

const std::map<std::string, Golden> kFiles = {
    {"anipose_mm.toml", {"anipose", unit(0.001)}},
    {"anipose_fisheye_mm.toml", {"anipose", unit(0.001)}},
    {"pose2sim.toml", {"pose2sim", {}}},
    {"camera_array.toml", {"caliscope", {}}},
    {"intrinsics.yml", {"opencv-stereo", stereo()}},
    {"extrinsics.yml", {"opencv-stereo", stereo()}},
    {"opencv_sample.yml", {"opencv", unit(0.01)}},
    {"ros", {"ros", {}}},
    {"camchain.yaml", {"kalibr", {}}},
    {"camchain_equi.yaml", {"kalibr", {}}},
    {"mrcal", {"mrcal", {}}},
    {"mc_calib.yml", {"mc-calib", unit(0.01)}},
    {"session.qca.txt", {"qualisys", {}}},
    {"multical.json", {"multical", unit(1.0)}},
};

struct ExpectedPixel {
  std::string file, camera;
  Eigen::Vector3d point;
  Eigen::Vector2d pixel;
};

std::vector<ExpectedPixel> expectedPixels() {
  std::vector<ExpectedPixel> list;
  std::ifstream stream(kGolden / "expected.csv");
  std::string line;
  while (std::getline(stream, line)) {
    if (line.starts_with("#")) {
      continue;
    }
    std::istringstream fields(line);
    ExpectedPixel one;
    std::getline(fields, one.file, ',');
    std::getline(fields, one.camera, ',');
    char comma = 0;
    fields >> one.point.x() >> comma >> one.point.y() >> comma >> one.point.z() >> comma >>
        one.pixel.x() >> comma >> one.pixel.y();
    list.push_back(one);
  }
  return list;
}

TEST(FormatGolden, EveryFilePutsItsPointsWhereItsToolDoes) {
  std::map<std::string, ParsedCalibration> read;
  for (const auto& [file, golden] : kFiles) {
    auto calibration = readCalibration(kGolden / file, golden.hints);
    ASSERT_TRUE(calibration) << errorSentence(calibration.error());
    EXPECT_EQ(calibration->format, golden.format) << file;
    EXPECT_FALSE(calibration->decisions.empty());
    read[file] = *calibration;
  }
  const auto expected = expectedPixels();
  ASSERT_EQ(expected.size(), 136U);
  for (const auto& one : expected) {
    ASSERT_TRUE(read.contains(one.file)) << one.file;
    const auto& rig = read[one.file].rig;
    const auto camera = std::ranges::find(rig, one.camera, &Camera::name);
    ASSERT_NE(camera, rig.end()) << one.file << " " << one.camera;
    const auto pixel = Projector(*camera).project(one.point);
    ASSERT_TRUE(pixel) << one.file << " " << one.camera;
    EXPECT_LT((*pixel - one.pixel).norm(), 1e-6) << one.file << " " << one.camera;
  }
}

TEST(FormatGolden, TheTwoFilesOfAPairAreOneFolder) {
  const auto folder = ownFolder() / "pair";
  std::filesystem::remove_all(folder); // of an earlier run
  std::filesystem::create_directories(folder);
  for (const char* name : {"intrinsics.yml", "extrinsics.yml"}) {
    std::filesystem::copy_file(kGolden / name, folder / name,
                               std::filesystem::copy_options::overwrite_existing);
  }
  const auto folderRead = readCalibration(folder, stereo());
  ASSERT_TRUE(folderRead) << errorSentence(folderRead.error());
  EXPECT_EQ(folderRead->format, "opencv-stereo");
  EXPECT_EQ(folderRead->rig, readCalibration(kGolden / "intrinsics.yml", stereo())->rig);
  for (const char* name : {"more_intrinsics.yml", "more_extrinsics.yml"}) {
    std::filesystem::copy_file(kGolden / std::string(name).substr(5), folder / name,
                               std::filesystem::copy_options::overwrite_existing);
  }
  const auto two = readCalibration(folder, stereo());
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().detail.find("more than one pair"), std::string::npos);
}

/// The error of a golden file with one piece of its text replaced.
Error errorOfGolden(const std::string& file, const std::string& from, const std::string& to,
                    const CalibrationHints& hints = {}) {
  std::ifstream stream(kGolden / file);
  std::stringstream buffer;
  buffer << stream.rdbuf();
  std::string text = buffer.str();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_NE(from, to) << file << " would stay as it is";
  text.replace(at, from.size(), to);
  const auto copy = ownFolder() / ("wrong_" + file);
  std::ofstream(copy) << text;
  const auto calibration = readCalibration(copy, hints);
  EXPECT_FALSE(calibration) << file << ": " << from;
  return calibration ? Error{} : calibration.error();
}

void expectSentence(const Error& error, const std::string& field, const std::string& words) {
  EXPECT_EQ(error.field, field) << errorSentence(error);
  EXPECT_NE(error.detail.find(words), std::string::npos) << errorSentence(error);
}

/// The error of a golden file as it is.
Error refusalOf(const std::string& file) {
  const auto calibration = readCalibration(kGolden / file, {});
  EXPECT_FALSE(calibration) << file;
  return calibration ? Error{} : calibration.error();
}

TEST(FormatGolden, WhatAFileDoesNotSayIsAskedFor) {
  expectSentence(refusalOf("anipose_mm.toml"), "unit", "probably mm");
  expectSentence(refusalOf("mc_calib.yml"), "unit", "--unit");
  expectSentence(refusalOf("multical.json"), "unit", "--unit");
  // Coefficients without the key that tells them apart.
  expectSentence(errorOfGolden("anipose_fisheye_mm.toml", "fisheye = true", "", unit(0.001)),
                 "cam_0.distortions", "--lens");
  const auto pair = readCalibration(kGolden / "intrinsics.yml", unit(0.025));
  ASSERT_FALSE(pair);
  expectSentence(pair.error(), "image_width", "--size");
}

TEST(FormatGolden, WrongUnitsAreNamedWithTheLikelyCause) {
  // Pose2Sim's meters written in mm: one camera hundreds of "m" away.
  expectSentence(errorOfGolden("pose2sim.toml", "0.37092653", "370.92653"), "translation",
                 "probably in mm");
  // Ours reads meters; the same file in mm without Anipose's mark.
  expectSentence(errorOfGolden("anipose_mm.toml", "adjusted", "remark"), "translation",
                 "probably in mm");
  // Qualisys' mm, of a file that somebody scaled to meters.
  auto scaled = readCalibration(kGolden / "session.qca.txt", unit(0.001));
  ASSERT_TRUE(scaled);
  for (Camera& camera : scaled->rig) {
    camera.cameraFromWorld.translation() *= 0.001;
  }
  const auto file = ownFolder() / "scaled.toml";
  ASSERT_TRUE(saveCalibration(scaled->rig, file));
  const auto calibration = loadCalibration(file);
  ASSERT_FALSE(calibration);
  expectSentence(calibration.error(), "translation", "probably already in meters");
}

TEST(FormatGolden, PosesTheWrongWayRoundAreSuspected) {
  auto rig = loadCalibration(kGolden / "camera_array.toml");
  ASSERT_TRUE(rig);
  for (Camera& camera : *rig) {
    camera.cameraFromWorld = camera.cameraFromWorld.inverse();
  }
  const auto file = ownFolder() / "inverted.toml";
  ASSERT_TRUE(saveCalibration(*rig, file));
  const auto doubted = readCalibration(file);
  ASSERT_FALSE(doubted);
  expectSentence(doubted.error(), "rotation", "--poses world-from-camera");
  CalibrationHints hints;
  hints.posesAreWorldFromCamera = true;
  const auto rotated = readCalibration(file, hints);
  ASSERT_TRUE(rotated) << errorSentence(rotated.error());
  hints.posesAreWorldFromCamera = false; // a person may know better
  EXPECT_TRUE(readCalibration(file, hints));
}

TEST(FormatGolden, BrokenFilesNameFileAndField) {
  const auto missing = errorOfGolden("camchain.yaml", "resolution", "resolutions");
  EXPECT_EQ(missing.code, ErrorCode::MissingKey);
  EXPECT_EQ(missing.field, "cam0.resolution");
  EXPECT_NE(missing.file.find("wrong_camchain.yaml"), std::string::npos);
  EXPECT_EQ(errorOfGolden("camera_array.toml", "-0.3321", "nan").field, "cameras.0.distortions");
  EXPECT_EQ(errorOfGolden("mc_calib.yml", "9.0350000000000000e+02", ".Nan").field,
            "camera_0.camera_matrix");
  EXPECT_EQ(errorOfGolden("session.qca.txt", "focalLengthU=", "focalLengthX=").field,
            "camera 26578.intrinsic.focalLengthU");
  EXPECT_EQ(errorOfGolden("session.qca.txt", "</cameras>", "").code, ErrorCode::NotParsed);
  EXPECT_EQ(errorOfGolden("camchain.yaml", "radtan", "fov").field, "cam0.distortion_model");
  EXPECT_EQ(errorOfGolden("opencv_sample.yml", "image_width", "image_w").field, "image_width");
  EXPECT_EQ(errorOfGolden("multical.json", "\"right_to_left\"", "\"right_to_up\"").field,
            "camera_poses.right");
  // A matrix of another resolution than the size.
  expectSentence(errorOfGolden("camera_array.toml", "size = [1280, 720]", "size = [320, 240]"),
                 "cam_0.matrix", "different resolutions");
}

TEST(FormatGolden, AFormatThatWasAskedForMustFit) {
  CalibrationHints hints;
  hints.format = "kalibr";
  const auto wrong = readCalibration(kGolden / "camera_array.toml", hints);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().detail.find("looks like a file of Caliscope"), std::string::npos);
  hints.format = "nonsense";
  EXPECT_EQ(readCalibration(kGolden / "camera_array.toml", hints).error().code,
            ErrorCode::NotFound);
  const auto other = readCalibration(kGolden / "expected.csv");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().detail.find("not a calibration"), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
