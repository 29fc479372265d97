// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_file.h"

#include "core/base/table_reader.h"
#include "core/base/text_file.h"
#include "core/calibration/camera_calibration.h"

namespace dewpoint {

Result<CameraRig> loadCalibration(const std::filesystem::path& file) {
  const auto table = readTomlFile(file);
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  CameraRig rig;
  for (const auto& [key, node] : *table) {
    const toml::table* section = node.as_table();
    if (section == nullptr || key.str() == "metadata") {
      continue;
    }
    auto camera = cameraFromToml(*section, file.string(), std::string(key.str()) + ".");
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    if (camera->name.empty()) {
      camera->name = key.str();
    }
    rig.push_back(std::move(*camera));
  }
  if (rig.empty()) {
    return failure(ErrorCode::MissingKey, file.string(), "cam_0", "the file holds no camera");
  }
  return rig;
}

Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file) {
  std::string text = "# Camera calibration: metres, radians, camera from world (OpenCV axes)\n";
  for (std::size_t k = 0; k < rig.size(); ++k) {
    text += fmt::format("\n[cam_{}]\nname = {}\n", k, quoted(rig[k].name)) +
            cameraToToml(rig[k], RotationForm::Vector);
  }
  return writeTextFile(file, text + "\n[metadata]\nunit = \"m\"\n");
}

} // namespace dewpoint
