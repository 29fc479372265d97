// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"

#include "core/base/text_file.h"
#include "core/base/toml_text.h"
#include "core/calibration/formats/calibration_format.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/calibration/formats/read_calibration.h"

#include <fmt/format.h>

namespace dewpoint::calibration {

Result<CameraRig> loadCalibration(const std::filesystem::path& file) {
  auto calibration = readCalibration(file);
  if (!calibration) {
    return tl::make_unexpected(calibration.error());
  }
  if (!calibration->hasPoses) {
    return failure(ErrorCode::MissingKey, file.string(), "pose",
                   "the file knows the lens only, not where the camera stands");
  }
  return std::move(calibration->rig);
}

std::string calibrationText(const CameraRig& rig) {
  std::string text = "# Camera calibration: meters, radians, camera from world (OpenCV axes)\n";
  for (std::size_t k = 0; k < rig.size(); ++k) {
    text += fmt::format("\n[cam_{}]\nname = {}\n", k, quoted(rig[k].name)) +
            cameraToToml(rig[k], RotationForm::Vector);
  }
  return text + "\n[metadata]\nunit = \"m\"\n";
}

Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file) {
  return writeTextFile(file, calibrationText(rig));
}

} // namespace dewpoint::calibration
