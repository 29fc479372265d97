// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/calibration_record.h"

#include <string>

namespace dewpoint::project {

/// Reads [camera.calibrated] from the table of a camera. `prefix` names the camera in errors.
CameraRecord readCameraRecord(TableReader& camera, const std::string& file,
                              const std::string& prefix);
/// Returns the table [camera.calibrated] as TOML, or an empty text if the record is empty.
std::string cameraRecordText(const CameraRecord& record);

/// Reads the table [calibrated] of a project file.
WorldRecord readWorldRecord(TableReader& project, const std::string& file);
/// Returns the table [calibrated] as TOML, or an empty text if the record is empty.
std::string worldRecordText(const WorldRecord& record);

} // namespace dewpoint::project
