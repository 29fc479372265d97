// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_mrcal.h"

#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/yaml_reader.h"
#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

#include <map>

namespace dewpoint::calibration {
namespace {

/// Within which the two poses of a file agree; radians and the unit of the file.
constexpr double kSamePose = 1e-6;

std::string recognizeMrcal(const CalibrationText& source) {
  return source.text.find("LENSMODEL_") != std::string::npos &&
                 source.text.find("lensmodel") != std::string::npos
             ? "a dictionary with \"lensmodel\""
             : "";
}

/// The text without the optimization inputs: a long bytes literal, b'...', that YAML cannot read.
std::string withoutInputs(std::string text) {
  const auto key = text.find("'optimization_inputs'");
  const auto open = key == std::string::npos ? key : text.find("b'", key);
  const auto close = open == std::string::npos ? open : text.find('\'', open + 2);
  if (close != std::string::npos) {
    text.replace(open, close + 1 - open, "''");
  }
  return text;
}

void readMrcalLens(const YamlReader& reader, CameraParts& parts) {
  static const std::map<std::string, std::size_t> kCoefficients = {
      {"LENSMODEL_PINHOLE", 0}, {"LENSMODEL_OPENCV4", 4},   {"LENSMODEL_OPENCV5", 5},
      {"LENSMODEL_OPENCV8", 8}, {"LENSMODEL_OPENCV12", 12},
  };
  const std::string model = reader.text("lensmodel");
  const auto known = kCoefficients.find(model);
  if (known == kCoefficients.end()) {
    reader.fail(model.empty() ? ErrorCode::MissingKey : ErrorCode::BadValue, "lensmodel",
                fmt::format("\"{}\" is not supported, only LENSMODEL_PINHOLE and LENSMODEL_OPENCV4 "
                            "to 12; mrcal-convert-lensmodel makes one of them",
                            model));
    return;
  }
  const auto in = reader.numbers("intrinsics", {4 + known->second});
  parts.matrix = matrixOf(in[0], in[1], in[2], in[3]);
  parts.distortion.assign(in.begin() + 4, in.end());
}

void readMrcalPose(const YamlReader& reader, CameraParts& parts) {
  const bool recent = reader.has("rt_cam_ref");
  const auto pose = reader.numbers(recent ? "rt_cam_ref" : "extrinsics", {6});
  if (recent && reader.has("extrinsics")) {
    const auto older = reader.numbers("extrinsics", {6});
    for (std::size_t i = 0; i < 6; ++i) {
      if (!(std::abs(pose[i] - older[i]) <= kSamePose)) {
        reader.fail(ErrorCode::Mismatch, "extrinsics", "another pose than rt_cam_ref");
        return;
      }
    }
  }
  parts.rotation = rotationFromVector({pose[0], pose[1], pose[2]});
  parts.translation = {pose[3], pose[4], pose[5]};
}

Result<ParsedCalibration> readMrcal(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto node = parseYaml(withoutInputs(source.text), file);
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  CameraParts parts;
  parts.name = source.file.stem().string();
  const auto size = reader.numbers("imagersize", {2});
  parts.width = size[0];
  parts.height = size[1];
  readMrcalLens(reader, parts);
  readMrcalPose(reader, parts);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  const char* pose = reader.has("rt_cam_ref") ? "rt_cam_ref" : "extrinsics";
  auto camera = checkedCamera(parts, file, {"imagersize", "intrinsics", "intrinsics", pose, pose});
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  ParsedCalibration calibration;
  calibration.decisions = {
      "The poses are stored as camera from reference; the reference becomes the world."};
  calibration.rig.push_back(std::move(*camera));
  return calibration;
}

std::string mrcalCameraText(const Camera& camera) {
  const auto& in = camera.intrinsics;
  std::vector<double> values = {in.focalX, in.focalY, in.centerX, in.centerY};
  std::string model = "LENSMODEL_PINHOLE";
  if (camera.hasDistortion()) {
    const auto coefficients = trimmedDistortion(camera, 4);
    values.insert(values.end(), coefficients.begin(), coefficients.end());
    model = fmt::format("LENSMODEL_OPENCV{}", coefficients.size());
  }
  Eigen::VectorXd pose(6);
  pose << vectorFromRotation(camera.cameraFromWorld.linear()), camera.cameraFromWorld.translation();
  // Both keys: releases before 2.5 know the second only.
  return fmt::format("{{\n    'lensmodel':  '{0}',\n\n"
                     "    # intrinsics are fx,fy,cx,cy,distortion0,distortion1,....\n"
                     "    'intrinsics': {1},\n\n"
                     "    # camera from reference: Rodrigues vector, translation\n"
                     "    'rt_cam_ref': {2},\n    'extrinsics': {2},\n\n"
                     "    'imagersize': [{3}, {4}],\n}}\n",
                     model, listText(values), listText(pose), in.width, in.height);
}

std::vector<CalibrationText> writeMrcal(const CameraRig& rig, const std::filesystem::path& out) {
  std::vector<CalibrationText> files;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    files.push_back({cameraFile(rig, k, out, ".cameramodel"), mrcalCameraText(rig[k])});
  }
  return files;
}

} // namespace

CalibrationFormat mrcalFormat() {
  CalibrationFormat format;
  format.name = "mrcal";
  format.title = "mrcal camera model";
  format.extension = ".cameramodel";
  format.description = "8 coefficients, one camera a file, camera from reference, meters";
  format.layout = FileLayout::FilePerCamera;
  format.lensSupport = {8, false};
  format.metersPerUnit = 1.0;
  format.recognize = recognizeMrcal;
  format.read = readMrcal;
  format.write = writeMrcal;
  return format;
}

} // namespace dewpoint::calibration
