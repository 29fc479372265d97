// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_kalibr.h"

#include "core/calibration/formats/camera_limit.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/yaml_reader.h"

#include <fmt/format.h>

namespace dewpoint::calibration {
namespace {

std::string recognizeKalibr(const CalibrationText& source) {
  return hasLineStartingWith(source.text, "cam0:") &&
                 hasLineStartingWith(source.text, "intrinsics:")
             ? "sections cam0, cam1, ... with \"intrinsics\""
             : "";
}

/// Fills the lens; false, with the error kept, for a model that is not OpenCV's.
bool readKalibrLens(const YamlReader& camera, CameraParts& parts) {
  const std::string model = camera.text("camera_model");
  if (model != "pinhole") {
    camera.fail(ErrorCode::BadValue, "camera_model",
                fmt::format("\"{}\" is not supported; calibrate again with pinhole-radtan or "
                            "pinhole-equi",
                            model));
    return false;
  }
  const std::string distortion = camera.text("distortion_model");
  if (distortion == "none") {
    return true;
  }
  if (distortion != "radtan" && distortion != "equidistant") {
    camera.fail(
        ErrorCode::BadValue, "distortion_model",
        fmt::format("\"{}\" is not supported, only radtan, equidistant and none", distortion));
    return false;
  }
  parts.lens = distortion == "radtan" ? LensModel::Pinhole : LensModel::Fisheye;
  parts.distortion = camera.numbers("distortion_coeffs", {4});
  return true;
}

std::optional<CameraParts> readParts(const YamlReader& camera, const std::string& name) {
  CameraParts parts;
  parts.name = name;
  const auto size = camera.numbers("resolution", {2});
  parts.width = size[0];
  parts.height = size[1];
  const auto in = camera.numbers("intrinsics", {4});
  parts.matrix = matrixOf(in[0], in[1], in[2], in[3]);
  if (!readKalibrLens(camera, parts) || camera.error()) {
    return std::nullopt;
  }
  return parts;
}

/// T_cn_cnm1 maps from the camera before to this one.
Eigen::Matrix4d stepFromPrevious(const YamlReader& camera, bool first) {
  if (first) {
    return Eigen::Matrix4d::Identity();
  }
  return camera.matrix("T_cn_cnm1", 4, 4);
}

Result<ParsedCalibration> readKalibr(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto node = parseYaml(source.text, file);
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  ParsedCalibration calibration;
  calibration.decisions = {
      "T_cn_cnm1 is the transform from the previous camera to each camera. The transforms were "
      "chained; the axes of cam0 are the world.",
      "camera_model, intrinsics: fu fv pu pv in pixels; timeshift_cam_imu is left out."};
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (int k = 0; reader.has(fmt::format("cam{}", k).c_str()); ++k) {
    if (calibration.rig.size() == limits::kMaxCameras) {
      return tooManyCamerasError(file);
    }
    const std::string name = fmt::format("cam{}", k);
    const YamlReader section = reader.child(name);
    auto parts = readParts(section, name);
    if (parts) {
      pose = stepFromPrevious(section, k == 0) * pose;
    }
    if (reader.error()) {
      return tl::make_unexpected(*reader.error());
    }
    parts->rotation = pose.topLeftCorner<3, 3>();
    parts->translation = pose.topRightCorner<3, 1>();
    auto camera = checkedCamera(*parts, file,
                                {section.fieldPath("resolution"), section.fieldPath("intrinsics"),
                                 section.fieldPath("distortion_coeffs"),
                                 section.fieldPath("T_cn_cnm1"), section.fieldPath("T_cn_cnm1")});
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    pose.topLeftCorner<3, 3>() = camera->cameraFromWorld.linear();
    calibration.rig.push_back(std::move(*camera));
  }
  if (calibration.rig.empty()) {
    return failure(ErrorCode::MissingKey, file, "cam0", "");
  }
  return calibration;
}

std::vector<CalibrationText> writeKalibr(const CameraRig& rig, const std::filesystem::path& out) {
  std::string text;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    const auto& in = camera.intrinsics;
    text += fmt::format("cam{}:\n", k);
    if (k > 0) {
      const Eigen::Matrix4d step =
          (camera.cameraFromWorld * rig[k - 1].cameraFromWorld.inverse()).matrix();
      text += "  T_cn_cnm1:\n";
      for (int row = 0; row < 4; ++row) {
        text += fmt::format("  - {}\n", listText(Eigen::VectorXd(step.row(row))));
      }
    }
    std::string overlaps;
    for (std::size_t other = 0; other < rig.size(); ++other) {
      overlaps += other == k ? "" : fmt::format("{}{}", overlaps.empty() ? "" : ", ", other);
    }
    const double intrinsics[] = {in.focalX, in.focalY, in.centerX, in.centerY};
    text += fmt::format("  cam_overlaps: [{}]\n  camera_model: pinhole\n  distortion_coeffs: {}\n"
                        "  distortion_model: {}\n  intrinsics: {}\n  resolution: [{}, {}]\n"
                        "  rostopic: /cam{}/image_raw\n",
                        overlaps, listText(trimmedDistortion(camera, 4)),
                        camera.lens == LensModel::Fisheye ? "equidistant" : "radtan",
                        listText(intrinsics), in.width, in.height, k);
  }
  return {{out, text}};
}

} // namespace

CalibrationFormat kalibrFormat() {
  CalibrationFormat format;
  format.name = "kalibr";
  format.title = "Kalibr camchain";
  format.extension = ".yaml";
  format.description =
      "4 coefficients (radtan) or fisheye (equidistant), each camera from the one before, "
      "meters; no names, no world";
  format.lensSupport = {4, true};
  format.firstCameraIsWorld = true;
  format.metersPerUnit = 1.0;
  format.recognize = recognizeKalibr;
  format.read = readKalibr;
  format.write = writeKalibr;
  return format;
}

} // namespace dewpoint::calibration
