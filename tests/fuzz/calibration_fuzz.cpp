// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/format_dewpoint.h"
#include "core/calibration/formats/read_calibration.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

#include <string>

namespace dewpoint::tests {
namespace {

/// What a calibration that was read is written to, and has to be read from.
void expectWritable(const CameraRig& rig) {
  static const InputFile kWritten("written.toml");
  CalibrationHints hints; // so that nothing is doubted that may not have been before
  hints.format = "dewpoint";
  hints.metersPerUnit = 1.0;
  hints.posesAreWorldFromCamera = false;
  const auto again = readCalibration(kWritten.hold(calibrationText(rig)), hints);
  if (!again) {
    expectPlain(again.error());
  }
  expect(again.has_value() && again->rig.size() == rig.size(),
         "a calibration that was read cannot be written and read again");
}

void readAs(const InputFile& file, const char* format, std::string_view bytes) {
  CalibrationHints hints;
  hints.format = format;
  // Half of the inputs with what a user may add.
  if (bytes.size() % 2 == 0) {
    hints.imageSize = {1280, 720};
    hints.lens = LensModel::Pinhole;
  }
  auto read = readCalibration(file.hold(bytes), hints);
  if (!read && read.error().field == "unit") {
    hints.metersPerUnit = 0.001;
    read = readCalibration(file.path(), hints);
  }
  if (!read) {
    expectPlain(read.error());
  } else {
    expect(!read->rig.empty(), "a calibration without a camera");
    expectWritable(read->rig);
  }
}

// As a camera of OpenCV's and ROS' would be.
constexpr const char* kIntrinsics = R"(%YAML:1.0
---
M1: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]
D1: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0.1, 0., 0., 0., 0. ]
M2: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]
D2: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0.1, 0., 0., 0., 0. ]
)";
constexpr const char* kCameraInfo = R"(image_width: 640
image_height: 480
camera_name: left
camera_matrix: {rows: 3, cols: 3, data: [500.0, 0.0, 320.0, 0.0, 500.0, 240.0, 0.0, 0.0, 1.0]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0.0, 0.0, 0.0, 0.0]}
)";

} // namespace

void fuzzCalibration(std::string_view bytes) {
  static const InputFile kFile("any.toml"); // so that broken TOML is recognized, too
  const auto rig = loadCalibration(kFile.hold(bytes));
  if (!rig) {
    expectPlain(rig.error());
  } else {
    expectWritable(*rig);
  }
}

void fuzzDewpoint(std::string_view bytes) {
  static const InputFile kFile("dewpoint.toml");
  readAs(kFile, "dewpoint", bytes);
}
void fuzzAnipose(std::string_view bytes) {
  static const InputFile kFile("anipose.toml");
  readAs(kFile, "anipose", bytes);
}
void fuzzPose2sim(std::string_view bytes) {
  static const InputFile kFile("pose2sim.toml");
  readAs(kFile, "pose2sim", bytes);
}
void fuzzCaliscope(std::string_view bytes) {
  static const InputFile kFile("caliscope.toml");
  readAs(kFile, "caliscope", bytes);
}
void fuzzOpencv(std::string_view bytes) {
  static const InputFile kFile("opencv.yml");
  readAs(kFile, "opencv", bytes);
}
void fuzzOpencvStereo(std::string_view bytes) {
  static const InputFile kFile("pair.yml"); // both parts in one file
  readAs(kFile, "opencv-stereo", bytes);
}
void fuzzRos(std::string_view bytes) {
  static const InputFile kFile("ros.yaml");
  readAs(kFile, "ros", bytes);
}
void fuzzKalibr(std::string_view bytes) {
  static const InputFile kFile("kalibr.yaml");
  readAs(kFile, "kalibr", bytes);
}
void fuzzMrcal(std::string_view bytes) {
  static const InputFile kFile("mrcal.cameramodel");
  readAs(kFile, "mrcal", bytes);
}
void fuzzMcCalib(std::string_view bytes) {
  static const InputFile kFile("mc-calib.yml");
  readAs(kFile, "mc-calib", bytes);
}
void fuzzQualisys(std::string_view bytes) {
  static const InputFile kFile("qualisys.qca.txt");
  readAs(kFile, "qualisys", bytes);
}
void fuzzMultical(std::string_view bytes) {
  static const InputFile kFile("multical.json");
  readAs(kFile, "multical", bytes);
}

void fuzzPlain(std::string_view bytes) {
  static const InputFile kFile("plain.json");
  readAs(kFile, "plain", bytes);
}

void fuzzOpencvExtrinsics(std::string_view bytes) {
  static const InputFile kIntrinsicsFile("pair/intrinsics.yml");
  static const InputFile kFile("pair/extrinsics.yml");
  (void)kFile.hold(bytes);
  CalibrationHints hints;
  hints.format = "opencv-stereo";
  hints.metersPerUnit = 0.001;
  hints.imageSize = {640, 480};
  const auto read = readCalibration(kIntrinsicsFile.hold(kIntrinsics), hints);
  if (!read) {
    expectPlain(read.error());
  }
}

void fuzzRosTransforms(std::string_view bytes) {
  static const InputFile kCameraFile("ros/left.yaml");
  static const InputFile kFile("ros/static_transforms.yaml");
  (void)kFile.hold(bytes);
  const auto read = readCalibration(kCameraFile.hold(kCameraInfo));
  if (!read) {
    expectPlain(read.error());
  }
}

void fuzzBoard(std::string_view bytes) {
  const std::string text(bytes);
  auto board = parseBoard(text, "--board");
  if (!board) {
    board.error().file = "argument"; // it has no file
    expectPlain(board.error());
  } else {
    expect(checkBoard(*board, "").has_value(), "a board that was read is not a board");
    expect(parseBoard(boardText(*board), "").has_value(), "a board cannot be written and read");
  }
}

} // namespace dewpoint::tests
