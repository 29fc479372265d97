// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_format.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"
#include "tests/calibration/own_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace dewpoint::tests {
namespace {

Result<ParsedCalibration> readText(const std::string& name, const std::string& text,
                                   const CalibrationHints& hints = {}) {
  const auto file = ownFolder() / name;
  std::ofstream(file) << text;
  return readCalibration(file, hints);
}

CalibrationHints inMeters() {
  CalibrationHints hints;
  hints.metersPerUnit = 1.0;
  return hints;
}

/// The camera of all these files: rotated by a right angle about x, 2 m behind the world's origin.
void expectTheCamera(const Camera& camera, const std::string& name) {
  EXPECT_EQ(camera.name, name);
  EXPECT_EQ(camera.intrinsics, (Intrinsics{640, 480, 500.0, 510.0, 320.0, 240.0}));
  EXPECT_NEAR(camera.distortion[0], -0.1, 1e-12);
  const Eigen::Vector3d point(0.1, 0.5, 0.2); // camera coordinates: 0.1, -0.2, 2.5
  const auto pixel = Projector(withoutPose(camera)).project({0.1, -0.2, 2.5});
  const auto found = Projector(camera).project(point);
  ASSERT_TRUE(found && pixel);
  EXPECT_LT((*found - *pixel).norm(), 1e-6);
}

TEST(FormatPlain, ReadsCamerasByName) {
  const auto read = readText("rig.json", R"({
"note": "made by a script",
"left": {"image_size": [640, 480], "K": [[500, 0, 320], [0, 510, 240], [0, 0, 1]],
  "dist": [-0.1, 0, 0, 0, 0], "R": [[1, 0, 0], [0, 0, -1], [0, 1, 0]], "t": [0, 0, 2]},
"right": {"width": 640, "height": 480, "camera_matrix": [500, 0, 320, 0, 510, 240, 0, 0, 1],
  "dist_coeffs": [[-0.1, 0, 0, 0, 0]], "rvec": [[1.5707963267948966], [0], [0]],
  "tvec": [[0], [0], [2]]}})",
                             inMeters());
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_EQ(read->format, "plain");
  ASSERT_EQ(read->rig.size(), 2U);
  expectTheCamera(read->rig[0], "left");
  expectTheCamera(read->rig[1], "right");
}

TEST(FormatPlain, ReadsAListInYamlWithItsUnit) {
  const auto read = readText("rig.yaml", R"(unit: mm
cameras:
  - name: a
    image_size: [640, 480]
    mtx: [[500, 0, 320], [0, 510, 240], [0, 0, 1]]
    dist: [-0.1, 0, 0, 0, 0]
    R: [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
    T: [0, 0, 2000]
  - image_size: [640, 480]
    intrinsic_matrix: [500, 0, 0, 0, 510, 0, 320, 240, 1]
    distortion: [-0.1, 0, 0, 0, 0]
    rotation: [1.5707963267948966, 0, 0]
    translation: [0, 0, 2000]
)");
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->rig.size(), 2U);
  expectTheCamera(read->rig[0], "a");
  expectTheCamera(read->rig[1], "camera 2"); // its matrix is written column by column
}

TEST(FormatPlain, ReadsFileStorageOfOneCamera) {
  const auto read = readText("front.yml", R"(%YAML:1.0
---
image_width: 640
image_height: 480
K: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 510., 240., 0., 0., 1. ]
D: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ -0.1, 0., 0., 0., 0. ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 1., 0., 0., 0., 0., -1., 0., 1., 0. ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ 0., 0., 2. ]
)",
                             inMeters());
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_EQ(read->format, "plain");
  expectTheCamera(read->rig.front(), "front");
}

TEST(FormatPlain, ReadsAFolderWithAFilePerCamera) {
  const char* const text = R"({"size": [640, 480], "K": [500, 0, 320, 0, 510, 240, 0, 0, 1],
"dist": [-0.1, 0, 0, 0, 0], "rvec": [1.5707963267948966, 0, 0], "t": [0, 0, 2]})";
  const auto folder = ownFolder() / "cameras";
  std::filesystem::create_directories(folder);
  for (const char* name : {"cam1.json", "cam2.json"}) {
    std::ofstream(folder / name) << text;
  }
  const auto read = readCalibration(folder, inMeters());
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->rig.size(), 2U);
  expectTheCamera(read->rig[1], "cam2");
}

TEST(FormatPlain, NoFileOfAFolderDecidesTheUnitOfAnother) {
  const auto text = [](const char* unit, double distance) {
    return R"({"size": [640, 480], "K": [500, 0, 320, 0, 510, 240, 0, 0, 1], )" +
           std::string(unit) +
           R"("dist": [-0.1, 0, 0, 0, 0], "rvec": [1.5707963267948966, 0, 0], "t": [0, 0, )" +
           std::to_string(distance) + "]}";
  };
  const auto folder = ownFolder() / "cameras";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "cam1.json") << text(R"("unit": "mm", )", 2000.0);
  std::ofstream(folder / "cam2.json") << text("", 2.0);
  const auto read = readCalibration(folder);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "cam2.json: unit");
  EXPECT_NE(read.error().detail.find("--unit"), std::string::npos) << read.error().detail;
  const auto asked = readCalibration(folder, inMeters());
  ASSERT_TRUE(asked) << errorSentence(asked.error());
  expectTheCamera(asked->rig[0], "cam1");
  expectTheCamera(asked->rig[1], "cam2");
  EXPECT_NE(
      std::ranges::find(asked->decisions, "cam2.json: lengths are in units of 1 m, as requested."),
      asked->decisions.end());
  // A unit that is not needed is still compared with that of the files.
  std::ofstream(folder / "cam2.json") << text(R"("unit": "m", )", 2.0);
  EXPECT_TRUE(readCalibration(folder));
  EXPECT_FALSE(readCalibration(folder, inMeters()));
}

TEST(FormatPlain, AsksForWhatIsMissing) {
  const std::string matrix = R"({"K": [500, 0, 320, 0, 510, 240, 0, 0, 1], )";
  const std::string pose = R"("R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "t": [0, 0, 1])";
  CalibrationHints hints = inMeters();
  auto read = readText("a.json", matrix + pose + "}", hints);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().detail.find("--size"), std::string::npos) << errorSentence(read.error());
  hints.imageSize = {640, 480};
  EXPECT_TRUE(readText("a.json", matrix + pose + "}", hints));

  const std::string four = matrix + pose + R"(, "dist": [0.1, 0, 0, 0]})";
  read = readText("b.json", four, hints);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().detail.find("--lens"), std::string::npos) << errorSentence(read.error());
  hints.lens = LensModel::Fisheye;
  read = readText("b.json", four, hints);
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_EQ(read->rig.front().lens, LensModel::Fisheye);

  hints.metersPerUnit.reset();
  read = readText("c.json", matrix + pose + "}", hints);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "unit") << errorSentence(read.error());
}

TEST(FormatPlain, NamesTheFieldThatIsWrong) {
  const std::string start = R"({"front": {"size": [640, 480],
"K": [500, 0, 320, 0, 510, 240, 0, 0, 1], )";
  auto read = readText("a.json", start + R"("R": [1, 0, 0, 0, 1, 0, 0, 0, 1]}})", inMeters());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "front.t") << errorSentence(read.error());
  read = readText("a.json", start + R"("R": [1, 0, 0], "t": [0, 0]}})", inMeters());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "front.t") << errorSentence(read.error());
  read = readText("a.json", start + R"("R": [1, 0, 0, 0, 1, 0, 0, 0, -1], "t": [0, 0, 1]}})",
                  inMeters());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "front.R");
  read = readText("a.json", R"({"unit": "parsec", "size": [640, 480], "R": [0, 0, 0],
"t": [0, 0, 1], "K": [500, 0, 320, 0, 510, 240, 0, 0, 1]})");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "unit");
}

} // namespace
} // namespace dewpoint::tests
