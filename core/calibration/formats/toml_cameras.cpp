// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/toml_cameras.h"

#include "core/base/toml_text.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/calibration/formats/camera_limit.h"

#include <algorithm>
#include <utility>

namespace dewpoint::calibration {
namespace {

using CameraTables = std::vector<std::pair<std::string, const toml::table*>>;

/// In the order of the file: toml++ sorts by name, which puts cam_10 before cam_2.
CameraTables cameraTables(const toml::table& table) {
  CameraTables tables;
  for (const auto& [key, node] : table) {
    if (const toml::table* section = node.as_table();
        section != nullptr && key.str() != "metadata") {
      tables.emplace_back(key.str(), section);
    }
  }
  std::ranges::stable_sort(tables, {},
                           [](const auto& item) { return item.second->source().begin.line; });
  return tables;
}

std::size_t coefficientCount(const toml::table& camera) {
  const toml::array* values = camera["distortions"].as_array();
  return values != nullptr ? values->size() : 0;
}

bool isPose2Sim(const CameraTables& cameras) {
  return std::ranges::all_of(cameras, [](const auto& item) {
    const toml::table& camera = *item.second;
    return camera["fisheye"].value<bool>() == false && coefficientCount(camera) == 4;
  });
}

} // namespace

TomlDialect recognizeTomlDialect(const CalibrationText& source) {
  const auto table = parseToml(source.text, source.file.string());
  if (!table) {
    return TomlDialect::None;
  }
  const auto cameras = cameraTables(*table);
  const auto isCamera = [](const auto& item) {
    return item.second->contains("matrix") || item.second->contains("translation");
  };
  if (std::ranges::none_of(cameras, isCamera)) {
    return TomlDialect::None;
  }
  const auto saysUnit = [](const auto& item) { return item.second->contains("unit"); };
  const auto metadata = (*table)["metadata"];
  if (metadata["unit"] || std::ranges::any_of(cameras, saysUnit)) {
    return TomlDialect::Dewpoint;
  }
  if (isPose2Sim(cameras)) {
    return TomlDialect::Pose2Sim;
  }
  return metadata["adjusted"] ? TomlDialect::Anipose : TomlDialect::Dewpoint;
}

Result<CameraRig> camerasFromToml(const CalibrationText& source,
                                  std::initializer_list<const char*> ignoredKeys) {
  const auto table = parseToml(source.text, source.file.string());
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  CameraRig rig;
  const CameraTables sections = cameraTables(*table);
  if (sections.size() > limits::kMaxCameras) {
    return tooManyCamerasError(source.file.string());
  }
  for (const auto& [key, section] : sections) {
    auto camera = cameraFromToml(*section, source.file.string(), key + ".", ignoredKeys);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    if (camera->name.empty()) {
      camera->name = key;
    }
    rig.push_back(std::move(*camera));
  }
  if (rig.empty()) {
    return failure(ErrorCode::MissingKey, source.file.string(), "cam_0",
                   "the file holds no camera");
  }
  return rig;
}

std::string cameraWithUnclearLens(const CalibrationText& source) {
  const auto table = parseToml(source.text, source.file.string());
  if (!table) {
    return "";
  }
  for (const auto& [key, section] : cameraTables(*table)) {
    if (coefficientCount(*section) == 4 && !section->contains("fisheye")) {
      return key;
    }
  }
  return "";
}

} // namespace dewpoint::calibration
