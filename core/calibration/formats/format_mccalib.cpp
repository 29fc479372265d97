// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_mccalib.h"

#include "core/base/limits.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/filestorage_text.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/yaml_reader.h"

#include <fmt/format.h>

namespace dewpoint::calibration {
namespace {

std::string recognizeMcCalib(const CalibrationText& source) {
  return hasLineStartingWith(source.text, "nb_camera:")
             ? "\"nb_camera\" and sections camera_0, camera_1, ..."
             : "";
}

Result<Camera> readMcCalibCamera(const YamlReader& section, const std::string& name,
                                 const std::string& file) {
  CameraParts parts;
  parts.name = name;
  parts.width = section.number("img_width");
  parts.height = section.number("img_height");
  parts.matrix = section.matrix("camera_matrix", 3, 3);
  parts.lens = section.number("distortion_type") == 1.0 ? LensModel::Fisheye : LensModel::Pinhole;
  parts.distortion = section.numbers("distortion_vector", {4, 5, 8});
  Eigen::Isometry3d rigFromCamera;
  rigFromCamera.matrix() = section.matrix("camera_pose_matrix", 4, 4);
  parts.rotation = rigFromCamera.linear().transpose();
  parts.translation = -(parts.rotation * rigFromCamera.translation());
  if (section.error()) {
    return tl::make_unexpected(*section.error());
  }
  return checkedCamera(parts, file,
                       {section.fieldPath("img_width"), section.fieldPath("camera_matrix"),
                        section.fieldPath("distortion_vector"),
                        section.fieldPath("camera_pose_matrix"),
                        section.fieldPath("camera_pose_matrix")});
}

Result<ParsedCalibration> readMcCalib(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto node = parseYaml(source.text, file);
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  const double count = reader.number("nb_camera");
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  if (!(count >= 1.0 && count <= double(limits::kMaxCameras))) {
    reader.fail(ErrorCode::BadValue, "nb_camera",
                fmt::format("1 to {} cameras are expected, found {}", limits::kMaxCameras, count));
    return tl::make_unexpected(*reader.error());
  }
  ParsedCalibration calibration;
  calibration.decisions = {"camera_pose_matrix is the transform rig from camera; it was inverted."};
  std::string group;
  for (int k = 0; k < count; ++k) {
    const std::string name = fmt::format("camera_{}", k);
    const YamlReader section = reader.child(name);
    auto camera = readMcCalibCamera(section, name, file);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    const std::string ownGroup = section.text("camera_group", "0");
    if (k > 0 && ownGroup != group) {
      return failure(ErrorCode::Mismatch, file, section.fieldPath("camera_group"),
                     "the cameras are in several groups, whose poses do not belong together");
    }
    group = ownGroup;
    calibration.rig.push_back(std::move(*camera));
  }
  return calibration;
}

std::vector<CalibrationText> writeMcCalib(const CameraRig& rig, const std::filesystem::path& out) {
  std::string text = fmt::format("%YAML:1.0\n---\nnb_camera: {}\n", rig.size());
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    const auto coefficients = trimmedDistortion(camera, 5);
    const bool fisheye = camera.lens == LensModel::Fisheye;
    text += fmt::format("camera_{}:\n", k) +
            matrixNodeText("   ", "camera_matrix", matrixOf(camera.intrinsics)) +
            matrixNodeText("   ", "distortion_vector", rowMatrix(coefficients)) +
            fmt::format("   distortion_type: {}\n   camera_group: 0\n   img_width: {}\n"
                        "   img_height: {}\n",
                        int(fisheye), camera.intrinsics.width, camera.intrinsics.height) +
            matrixNodeText("   ", "camera_pose_matrix", camera.cameraFromWorld.inverse().matrix());
  }
  return {{out, text}};
}

} // namespace

CalibrationFormat mcCalibFormat() {
  CalibrationFormat format;
  format.name = "mc-calib";
  format.title = "MC-Calib";
  format.extension = ".yml";
  format.description =
      "5 coefficients or fisheye, poses as rig (the first camera) from camera, in the unit "
      "of its board; no names, no world";
  format.lensSupport = {5, true};
  format.firstCameraIsWorld = true;
  format.recognize = recognizeMcCalib;
  format.read = readMcCalib;
  format.write = writeMcCalib;
  return format;
}

} // namespace dewpoint::calibration
