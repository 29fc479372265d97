// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_opencv.h"

#include "core/base/text_file.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/filestorage_text.h"
#include "core/calibration/formats/format_plain.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/yaml_reader.h"
#include "core/geometry/camera_name.h"
#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

namespace dewpoint::calibration {
namespace {

bool isFileStorage(const std::string& text) {
  return text.find("!!opencv-matrix") != std::string::npos;
}

std::string recognizeCamera(const CalibrationText& source) {
  return isFileStorage(source.text) && hasLineStartingWith(source.text, "camera_matrix:") &&
                 !hasLineStartingWith(source.text, "nb_camera:") && !hasPlainPose(source.text)
             ? "an OpenCV FileStorage with camera_matrix"
             : "";
}

bool isIntrinsics(const std::string& text) {
  return hasLineStartingWith(text, "M1:");
}
bool isExtrinsics(const std::string& text) {
  const auto has = [&](const char* start) { return hasLineStartingWith(text, start); };
  const bool isOneCamera = has("K:") || has("mtx:") || has("camera_matrix:");
  return has("R:") && has("T:") && !isOneCamera;
}

std::string recognizePair(const CalibrationText& source) {
  if (!isFileStorage(source.text)) {
    return "";
  }
  return isIntrinsics(source.text)   ? "an OpenCV FileStorage with M1, D1, M2, D2"
         : isExtrinsics(source.text) ? "an OpenCV FileStorage with R and T of a pair"
                                     : "";
}

void readOpenCvSize(const YamlReader& reader, const CalibrationHints& hints, CameraParts& parts) {
  if (reader.has("image_width") || !hints.imageSize) {
    parts.width = reader.number("image_width");
    parts.height = reader.number("image_height");
  } else {
    parts.width = (*hints.imageSize)[0];
    parts.height = (*hints.imageSize)[1];
  }
}

/// The pose of the only view, when the file has just one: its board is the world then.
void readView(const YamlReader& reader, CameraParts& parts, ParsedCalibration& calibration) {
  calibration.hasPoses = false;
  if (!reader.has("extrinsic_parameters")) {
    return;
  }
  const auto views = reader.numbers("extrinsic_parameters", {});
  if (views.size() < 6 || views.size() % 6 != 0) {
    reader.fail(ErrorCode::WrongType, "extrinsic_parameters",
                "six numbers per view are expected: rotation vector, translation");
  } else if (views.size() > 6) {
    calibration.decisions.push_back(fmt::format(
        "The {} poses are those of a moved board, not of the camera, and were left out.",
        views.size() / 6));
  } else {
    calibration.hasPoses = true;
    parts.rotation = rotationFromVector({views[0], views[1], views[2]});
    parts.translation = {views[3], views[4], views[5]};
    calibration.decisions.emplace_back("The world is defined by the board in the only view.");
  }
}

Result<ParsedCalibration> readOpenCvCamera(const CalibrationText& source,
                                           const CalibrationHints& hints) {
  const std::string file = source.file.string();
  const auto node = parseYaml(source.text, file);
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  ParsedCalibration calibration;
  CameraParts parts;
  parts.name = source.file.stem().string();
  readOpenCvSize(reader, hints, parts);
  parts.matrix = reader.matrix("camera_matrix", 3, 3);
  parts.distortion = reader.numbers("distortion_coefficients", {4, 5, 8, 12, 14});
  if (reader.text("fisheye_model", "0") == "1" || hints.lens == LensModel::Fisheye) {
    parts.lens = LensModel::Fisheye;
    calibration.decisions.emplace_back("Coefficients are those of cv::fisheye.");
  }
  readView(reader, parts, calibration);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  auto camera = checkedCamera(parts, file,
                              {"image_width", "camera_matrix", "distortion_coefficients",
                               "extrinsic_parameters", "extrinsic_parameters"});
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  calibration.rig.push_back(std::move(*camera));
  return calibration;
}

std::vector<CalibrationText> writeCameras(const CameraRig& rig, const std::filesystem::path& out) {
  std::vector<CalibrationText> files;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    const auto& in = camera.intrinsics;
    Eigen::MatrixXd view(1, 6);
    view << vectorFromRotation(camera.cameraFromWorld.linear()).transpose(),
        camera.cameraFromWorld.translation().transpose();
    std::string text =
        fmt::format("%YAML:1.0\n---\nimage_width: {}\nimage_height: {}\n", in.width, in.height);
    if (camera.lens == LensModel::Fisheye) {
      text += "fisheye_model: 1\n";
    }
    text += matrixNodeText("", "camera_matrix", matrixOf(in)) +
            matrixNodeText("", "distortion_coefficients",
                           rowMatrix(trimmedDistortion(camera, 5)).transpose()) +
            matrixNodeText("", "extrinsic_parameters", view);
    files.push_back({cameraFile(rig, k, out, ".yml"), text});
  }
  return files;
}

/// The other file of a pair: intrinsics.yml and extrinsics.yml, whatever is around these words.
std::filesystem::path otherFileOfPair(const std::filesystem::path& file, bool isIntrinsicsFile) {
  const std::string own = isIntrinsicsFile ? "intrinsic" : "extrinsic";
  const std::string other = isIntrinsicsFile ? "extrinsic" : "intrinsic";
  std::string name = file.filename().string();
  if (const auto at = name.find(own); at != std::string::npos) {
    return file.parent_path() / name.replace(at, own.size(), other);
  }
  return file.parent_path() / (other + "s" + file.extension().string());
}

Result<ParsedCalibration> readPair(const CalibrationText& source, const CalibrationHints& hints) {
  const std::string file = source.file.string();
  std::string text[2] = {source.text, source.text};
  std::filesystem::path files[2] = {source.file, source.file};
  const bool hasIntrinsics = isIntrinsics(source.text);
  if (!hasIntrinsics || !isExtrinsics(source.text)) {
    const int missing = hasIntrinsics ? 1 : 0;
    files[missing] = otherFileOfPair(source.file, hasIntrinsics);
    auto other = readTextFile(files[missing]);
    if (!other) {
      return failure(
          ErrorCode::FileMissing, file, hasIntrinsics ? "R" : "M1",
          fmt::format("a pair of cameras has two files: {} is expected in the same folder",
                      files[missing].filename().string()));
    }
    text[missing] = std::move(*other);
  }
  const auto inner = parseYaml(text[0], files[0].string());
  const auto outer = inner ? parseYaml(text[1], files[1].string()) : inner;
  if (!outer) {
    return tl::make_unexpected(outer.error());
  }
  const YamlReader intrinsics(*inner, files[0].string());
  const YamlReader extrinsics(*outer, files[1].string());
  if (!hints.imageSize && !intrinsics.has("image_width")) {
    return failure(
        ErrorCode::MissingKey, files[0].string(), "image_width",
        "the stereo sample does not write the image size; convert with --size WIDTHxHEIGHT");
  }
  ParsedCalibration calibration;
  calibration.decisions = {"The axes of the first camera are the world; R and T are the transform "
                           "from the first camera to the second."};
  for (const char* number : {"1", "2"}) {
    CameraParts parts;
    const std::string matrix = std::string("M") + number;
    const std::string distortion = std::string("D") + number;
    parts.name = defaultCameraName(calibration.rig.size()); // they are read in order
    readOpenCvSize(intrinsics, hints, parts);
    parts.matrix = intrinsics.matrix(matrix.c_str(), 3, 3);
    parts.distortion = intrinsics.numbers(distortion.c_str(), {4, 5, 8, 12, 14});
    if (calibration.rig.size() == 1) {
      parts.rotation = extrinsics.matrix("R", 3, 3);
      parts.translation = extrinsics.matrix("T", 3, 1);
    }
    for (const auto* reader : {&intrinsics, &extrinsics}) {
      if (reader->error()) {
        return tl::make_unexpected(*reader->error());
      }
    }
    auto camera = checkedCamera(parts, file, {"image_width", matrix, distortion, "R", "T"});
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    calibration.rig.push_back(std::move(*camera));
  }
  return calibration;
}

std::vector<CalibrationText> writePair(const CameraRig& rig, const std::filesystem::path& out) {
  const auto& size = rig.front().intrinsics;
  std::string inner = "%YAML:1.0\n---\n";
  for (std::size_t k = 0; k < 2; ++k) {
    inner += matrixNodeText("", fmt::format("M{}", k + 1), matrixOf(rig[k].intrinsics)) +
             matrixNodeText("", fmt::format("D{}", k + 1), rowMatrix(trimmedDistortion(rig[k], 5)));
  }
  inner += fmt::format("image_width: {}\nimage_height: {}\n", size.width, size.height);
  const Eigen::Isometry3d second = rig[1].cameraFromWorld * rig[0].cameraFromWorld.inverse();
  const std::string outer = "%YAML:1.0\n---\n" + matrixNodeText("", "R", second.linear()) +
                            matrixNodeText("", "T", second.translation());
  return {{out, inner}, {otherFileOfPair(out, true), outer}};
}

} // namespace

CalibrationFormat opencvFormat() {
  CalibrationFormat format;
  format.name = "opencv";
  format.title = "OpenCV calibration sample";
  format.extension = ".yml";
  format.description = "8 coefficients or fisheye, one camera a file, the pose as the one view's "
                       "(camera from board), in the unit of its board";
  format.layout = FileLayout::FilePerCamera;
  format.lensSupport = {8, true};
  format.recognize = recognizeCamera;
  format.read = readOpenCvCamera;
  format.write = writeCameras;
  return format;
}

CalibrationFormat opencvStereoFormat() {
  CalibrationFormat format;
  format.name = "opencv-stereo";
  format.title = "OpenCV stereo sample";
  format.extension = ".yml";
  format.description =
      "8 coefficients, two cameras with images of one size, the second from the first, in "
      "the unit of its board; no names, no world";
  format.layout = FileLayout::CameraPair;
  format.lensSupport = {8, false};
  format.firstCameraIsWorld = true;
  format.recognize = recognizePair;
  format.read = readPair;
  format.write = writePair;
  return format;
}

} // namespace dewpoint::calibration
