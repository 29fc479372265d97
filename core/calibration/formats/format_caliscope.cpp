// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_caliscope.h"

#include "core/base/toml_text.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/calibration/formats/camera_limit.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::calibration {
namespace {

std::string recognizeCaliscope(const CalibrationText& source) {
  return hasLineStartingWith(source.text, "[cameras.") ? "tables [cameras.N]" : "";
}

Status readCaliscopeCamera(const std::string& key, const toml::table& table,
                           const std::string& file, ParsedCalibration& calibration) {
  const std::string name = "cam_" + key;
  if (table["ignore"].value_or(false)) {
    calibration.decisions.push_back(
        fmt::format("Camera {} was left out, because the file marks it as ignored.", key));
    return {};
  }
  if (!table.contains("rotation") || !table.contains("translation")) {
    return failure(ErrorCode::MissingKey, file, fmt::format("cameras.{}.rotation", key),
                   "the camera has no pose yet; is this the file from before the extrinsic "
                   "calibration?");
  }
  auto camera = cameraFromToml(table, file, fmt::format("cameras.{}.", key),
                               {"cam_id", "port", "rotation_count", "error", "exposure",
                                "grid_count", "ignore", "verified_resolutions"});
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  if (camera->name.empty()) {
    camera->name = name;
  }
  if (const auto* turns = table["rotation_count"].as_integer();
      turns != nullptr && turns->get() != 0) {
    calibration.decisions.push_back(fmt::format(
        "Caliscope shows camera {} rotated; its calibration is for the unrotated image.", key));
  }
  calibration.rig.push_back(std::move(*camera));
  return {};
}

Result<ParsedCalibration> readCaliscope(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  const auto table = parseToml(source.text, file);
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  const toml::table* cameras = (*table)["cameras"].as_table();
  if (cameras == nullptr) {
    return failure(ErrorCode::MissingKey, file, "cameras", "");
  }
  ParsedCalibration calibration;
  calibration.decisions = {"The poses are stored as camera from world, as in Dewpoint."};
  std::vector<std::pair<std::string, const toml::table*>> sections;
  for (const auto& [key, node] : *cameras) {
    if (node.is_table()) {
      sections.emplace_back(key.str(), node.as_table());
    }
  }
  std::ranges::stable_sort(sections, {},
                           [](const auto& section) { return section.second->source().begin.line; });
  if (sections.size() > limits::kMaxCameras) {
    return tooManyCamerasError(file);
  }
  for (const auto& [key, section] : sections) {
    if (const auto status = readCaliscopeCamera(key, *section, file, calibration); !status) {
      return tl::make_unexpected(status.error());
    }
  }
  return calibration;
}

std::vector<CalibrationText> writeCaliscope(const CameraRig& rig,
                                            const std::filesystem::path& out) {
  std::string text;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    const auto& in = camera.intrinsics;
    text += fmt::format("[cameras.{0}]\ncam_id = {0}\nsize = [{1}, {2}]\nrotation_count = 0\n"
                        "error = 0.0\nmatrix = {3}\ndistortions = {4}\ntranslation = {5}\n"
                        "rotation = {6}\nexposure = 0\ngrid_count = 0\nignore = false\n"
                        "fisheye = {7}\n\n",
                        k, in.width, in.height, matrixListText(matrixOf(in)),
                        listText(trimmedDistortion(camera, 5)),
                        listText(Eigen::VectorXd(camera.cameraFromWorld.translation())),
                        matrixListText(camera.cameraFromWorld.linear()),
                        camera.lens == LensModel::Fisheye);
  }
  return {{out, text}};
}

} // namespace

CalibrationFormat caliscopeFormat() {
  CalibrationFormat format;
  format.name = "caliscope";
  format.title = "Caliscope";
  format.extension = ".toml";
  format.description =
      "5 coefficients or fisheye, camera from world, meters; numbers instead of names";
  format.lensSupport = {5, true};
  format.metersPerUnit = 1.0;
  format.recognize = recognizeCaliscope;
  format.read = readCaliscope;
  format.write = writeCaliscope;
  return format;
}

} // namespace dewpoint::calibration
