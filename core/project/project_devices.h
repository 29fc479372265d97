// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/capture/device_settings.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the keys `pixel_format`, `size` and `rate` and the tables [camera.identity] and
/// [camera.controls] of a [[camera]]. Only a camera with a `device` may have them.
void readDeviceSettings(TableReader& reader, const std::string& file, const std::string& prefix,
                        ProjectCamera& camera);

/// Returns the same keys as TOML; empty if no format is requested.
std::string deviceFormatText(const DeviceFormat& format);
/// Returns the same tables as TOML; empty if the settings have neither.
std::string deviceTablesText(const DeviceSettings& settings);

/// Checks the settings of a device. BadValue names the key, as "size".
Status checkDeviceSettings(const DeviceSettings& settings);

} // namespace dewpoint::project
