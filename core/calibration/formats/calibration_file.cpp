// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"

#include "core/base/text_file.h"
#include "core/calibration/formats/format_dewpoint.h"
#include "core/calibration/formats/read_calibration.h"

#include <utility>

namespace dewpoint::calibration {

Result<CameraRig> loadCalibration(const std::filesystem::path& file) {
  auto calibration = readCalibration(file);
  if (!calibration) {
    return tl::make_unexpected(calibration.error());
  }
  if (!calibration->hasPoses) {
    return failure(ErrorCode::MissingKey, file.string(), "pose",
                   "the file contains only the intrinsics, not the pose of the camera");
  }
  return std::move(calibration->rig);
}

Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file) {
  return writeTextFile(file, calibrationText(rig));
}

} // namespace dewpoint::calibration
