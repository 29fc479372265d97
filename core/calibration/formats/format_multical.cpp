// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_multical.h"

#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/yaml_reader.h"

#include <fmt/format.h>

#include <map>

namespace dewpoint::calibration {
namespace {

std::string recognizeMultical(const CalibrationText& source) {
  const auto start = source.text.find_first_not_of(" \t\r\n");
  return start != std::string::npos && source.text[start] == '{' &&
                 source.text.find("\"camera_poses\"") != std::string::npos
             ? "JSON with \"cameras\" and \"camera_poses\""
             : "";
}

Result<CameraParts> readMulticalLens(const YamlReader& camera, const std::string& name) {
  CameraParts parts;
  parts.name = name;
  const auto size = camera.numbers("image_size", {2});
  parts.width = size[0];
  parts.height = size[1];
  parts.matrix = camera.matrix("K", 3, 3);
  if (camera.text("model") == "fisheye") {
    parts.lens = LensModel::Fisheye;
  }
  parts.distortion = camera.numbers("dist", {});
  if (camera.error()) {
    return tl::make_unexpected(*camera.error());
  }
  return parts;
}

struct PoseEntry {
  std::string parent; ///< empty: the reference
  Eigen::Isometry3d fromParent = Eigen::Isometry3d::Identity();
};

/// "cam2_to_cam1" is cam2 from cam1; a bare name is the reference itself.
PoseEntry readMulticalPose(const YamlReader& poses, const std::string& key) {
  const YamlReader entry = poses.child(key);
  PoseEntry pose;
  if (const auto to = key.find("_to_"); to != std::string::npos) {
    pose.parent = key.substr(to + 4);
  }
  pose.fromParent.linear() = entry.matrix("R", 3, 3);
  pose.fromParent.translation() = entry.matrix("T", 3, 1);
  return pose;
}

/// The pose of a camera through its parents; nothing for a chain that does not end.
std::optional<Eigen::Isometry3d> poseThroughParents(const std::map<std::string, PoseEntry>& poses,
                                                    std::string name) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t step = 0; step <= poses.size(); ++step) {
    const auto entry = poses.find(name);
    if (entry == poses.end()) {
      return std::nullopt;
    }
    pose = pose * entry->second.fromParent;
    if (entry->second.parent.empty()) {
      return pose;
    }
    name = entry->second.parent;
  }
  return std::nullopt;
}

Result<ParsedCalibration> readMultical(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto node = parseYaml(source.text, file); // JSON is YAML
  if (!node) {
    return tl::make_unexpected(node.error());
  }
  const YamlReader reader(*node, file);
  const YamlReader cameras = reader.child("cameras");
  const YamlReader poses = reader.child("camera_poses");
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  std::map<std::string, PoseEntry> entries;
  for (const std::string& key : poses.keys()) {
    entries[key.substr(0, key.find("_to_"))] = readMulticalPose(poses, key);
  }
  ParsedCalibration calibration;
  calibration.decisions = {"\"b_to_a\" is the transform b from a. The transforms were chained; the "
                           "axes of the first camera are the world."};
  for (const std::string& name : cameras.keys()) {
    const YamlReader section = cameras.child(name);
    auto parts = readMulticalLens(section, name);
    if (!parts) {
      return tl::make_unexpected(parts.error());
    }
    const auto pose = poseThroughParents(entries, name);
    if (!pose) {
      return failure(ErrorCode::MissingKey, file, "camera_poses." + name,
                     "no chain of poses leads from this camera to the first");
    }
    parts->rotation = pose->linear();
    parts->translation = pose->translation();
    auto camera =
        checkedCamera(*parts, file,
                      {section.fieldPath("image_size"), section.fieldPath("K"),
                       section.fieldPath("dist"), "camera_poses." + name, "camera_poses." + name});
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    calibration.rig.push_back(std::move(*camera));
  }
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  return calibration;
}

} // namespace

CalibrationFormat multicalFormat() {
  CalibrationFormat format;
  format.name = "multical";
  format.title = "multical";
  format.extension = ".json";
  format.description =
      "8 coefficients or fisheye, each camera from another, in the unit of its board";
  format.lensSupport = {8, true};
  format.firstCameraIsWorld = true;
  format.recognize = recognizeMultical;
  format.read = readMultical;
  return format;
}

} // namespace dewpoint::calibration
