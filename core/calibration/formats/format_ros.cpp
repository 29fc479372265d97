// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_ros.h"

#include "core/base/text_file.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/yaml_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace dewpoint::calibration {
namespace {

constexpr const char* kTransforms = "static_transforms.yaml";
constexpr const char* kFrameEnding = "_optical_frame";

std::string recognizeRos(const CalibrationText& source) {
  const bool fits = source.text.find("!!opencv-matrix") == std::string::npos &&
                    hasLineStartingWith(source.text, "camera_matrix:") &&
                    (hasLineStartingWith(source.text, "distortion_model:") ||
                     hasLineStartingWith(source.text, "image_width:"));
  return fits ? "YAML with camera_matrix and distortion_model, and no OpenCV tags" : "";
}

void readRosLens(const YamlReader& reader, CameraParts& parts) {
  const std::string model = reader.text("distortion_model");
  if (model == "plumb_bob") {
    parts.distortion = reader.numbers("distortion_coefficients", {5, 4});
  } else if (model == "rational_polynomial") {
    parts.distortion = reader.numbers("distortion_coefficients", {8});
  } else if (model == "equidistant" || model == "fisheye") {
    parts.distortion = reader.numbers("distortion_coefficients", {4});
    parts.lens = LensModel::Fisheye;
  } else {
    reader.fail(model.empty() ? ErrorCode::MissingKey : ErrorCode::BadValue, "distortion_model",
                "plumb_bob, rational_polynomial or equidistant is expected");
  }
}

/// The quaternion of one transform, not yet normalized.
Eigen::Quaterniond quaternion(const YamlReader& rotation) {
  return {rotation.number("w"), rotation.number("x"), rotation.number("y"), rotation.number("z")};
}

/// The pose of the frame `child` in the world, from a list of geometry_msgs/TransformStamped:
/// parent from child. Nothing when it is not in the list.
Result<std::optional<Eigen::Isometry3d>> worldFrom(const std::string& child,
                                                   const std::filesystem::path& file) {
  const auto text = readTextFile(file);
  const auto list = text ? parseYaml(*text, file.string()) : tl::make_unexpected(text.error());
  if (!list) {
    return tl::make_unexpected(list.error());
  }
  for (std::size_t i = 0; list->IsSequence() && i < list->size(); ++i) {
    const YamlReader entry((*list)[i], file.string(), fmt::format("{}.", i));
    if (entry.text("child_frame_id") != child) {
      continue;
    }
    const YamlReader transform = entry.child("transform");
    const YamlReader shift = transform.child("translation");
    const YamlReader turn = transform.child("rotation");
    const Eigen::Quaterniond rotation = quaternion(turn);
    const Eigen::Vector3d translation(shift.number("x"), shift.number("y"), shift.number("z"));
    if (!entry.error() && !(std::abs(rotation.norm() - 1.0) < 1e-3)) {
      turn.fail(ErrorCode::BadValue, "w", "the quaternion x y z w does not have length 1");
    }
    if (entry.error()) {
      return tl::make_unexpected(*entry.error());
    }
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation.normalized().toRotationMatrix();
    pose.translation() = translation;
    return std::optional(pose);
  }
  return std::optional<Eigen::Isometry3d>();
}

Status readRosPose(const CalibrationText& source, CameraParts& parts,
                   ParsedCalibration& calibration) {
  const auto transforms = source.file.parent_path() / kTransforms;
  std::error_code ignored;
  calibration.hasPoses = std::filesystem::exists(transforms, ignored);
  if (!calibration.hasPoses) {
    return {};
  }
  const std::string child = parts.name + kFrameEnding;
  const auto pose = worldFrom(child, transforms);
  if (!pose) {
    return tl::make_unexpected(pose.error());
  }
  if (!*pose) {
    return failure(ErrorCode::MissingKey, transforms.string(), "child_frame_id",
                   fmt::format("no transform of {}", child));
  }
  const Eigen::Isometry3d cameraFromWorld = (*pose)->inverse();
  parts.rotation = cameraFromWorld.linear();
  parts.translation = cameraFromWorld.translation();
  calibration.decisions.push_back(fmt::format("The poses are those of the frames *{} in {}. They "
                                              "are stored as world from camera and were inverted.",
                                              kFrameEnding, kTransforms));
  return {};
}

Result<ParsedCalibration> readRos(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto node = parseYaml(source.text, file);
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  CameraParts parts;
  parts.name = reader.text("camera_name", source.file.stem().string());
  parts.width = reader.number("image_width");
  parts.height = reader.number("image_height");
  parts.matrix = reader.matrix("camera_matrix", 3, 3);
  readRosLens(reader, parts);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  ParsedCalibration calibration;
  calibration.decisions = {"Intrinsics are camera_matrix and its coefficients, for unrectified "
                           "images; rectification and projection_matrix are left out."};
  if (const auto status = readRosPose(source, parts, calibration); !status) {
    return tl::make_unexpected(status.error());
  }
  auto camera = checkedCamera(
      parts, file,
      {"image_width", "camera_matrix", "distortion_coefficients", "rotation", "translation"});
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  calibration.rig.push_back(std::move(*camera));
  return calibration;
}

std::string matrixText(const char* key, const Eigen::MatrixXd& matrix) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = matrix;
  return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: {}\n", key, matrix.rows(), matrix.cols(),
                     listText(std::span(rows.data(), std::size_t(rows.size()))));
}

std::string rosCameraText(const Camera& camera) {
  const auto coefficients = trimmedDistortion(camera, 5);
  const char* model = camera.lens == LensModel::Fisheye ? "equidistant"
                      : coefficients.size() == 8        ? "rational_polynomial"
                                                        : "plumb_bob";
  Eigen::Matrix<double, 3, 4> projection = Eigen::Matrix<double, 3, 4>::Zero();
  projection.leftCols<3>() = matrixOf(camera.intrinsics);
  const Eigen::Map<const Eigen::RowVectorXd> row(coefficients.data(),
                                                 Eigen::Index(coefficients.size()));
  return fmt::format("image_width: {}\nimage_height: {}\ncamera_name: {}\n",
                     camera.intrinsics.width, camera.intrinsics.height,
                     YAML::Dump(YAML::Node(camera.name))) +
         matrixText("camera_matrix", matrixOf(camera.intrinsics)) +
         fmt::format("distortion_model: {}\n", model) + matrixText("distortion_coefficients", row) +
         matrixText("rectification_matrix", Eigen::Matrix3d::Identity()) +
         matrixText("projection_matrix", projection);
}

std::string transformText(const Camera& camera) {
  const Eigen::Isometry3d pose = camera.cameraFromWorld.inverse();
  const Eigen::Quaterniond turn(pose.linear());
  const auto& at = pose.translation();
  return fmt::format("- header:\n    frame_id: world\n  child_frame_id: {}\n  transform:\n"
                     "    translation: {{x: {}, y: {}, z: {}}}\n"
                     "    rotation: {{x: {}, y: {}, z: {}, w: {}}}\n",
                     YAML::Dump(YAML::Node(camera.name + kFrameEnding)), numberText(at.x()),
                     numberText(at.y()), numberText(at.z()), numberText(turn.x()),
                     numberText(turn.y()), numberText(turn.z()), numberText(turn.w()));
}

std::vector<CalibrationText> writeRos(const CameraRig& rig, const std::filesystem::path& out) {
  std::vector<CalibrationText> files;
  std::string transforms = "# geometry_msgs/TransformStamped, for static_transform_publisher\n";
  for (std::size_t k = 0; k < rig.size(); ++k) {
    files.push_back({cameraFile(rig, k, out, ".yaml"), rosCameraText(rig[k])});
    transforms += transformText(rig[k]);
  }
  files.push_back({files.front().file.parent_path() / kTransforms, transforms});
  return files;
}

} // namespace

CalibrationFormat rosFormat() {
  CalibrationFormat format;
  format.name = "ros";
  format.title = "ROS camera_info";
  format.extension = ".yaml";
  format.description =
      "8 coefficients (plumb_bob, rational_polynomial) or fisheye (equidistant), one "
      "camera a file; poses in static_transforms.yaml beside it, meters";
  format.layout = FileLayout::FilePerCamera;
  format.lensSupport = {8, true};
  format.metersPerUnit = 1.0;
  format.recognize = recognizeRos;
  format.read = readRos;
  format.write = writeRos;
  return format;
}

} // namespace dewpoint::calibration
