// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/capture/device_settings.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the device settings of a [[camera]]: the keys `pixel_format`, `size` and `rate`, and the
/// tables [camera.identity] and [camera.controls]. They are errors for a camera without the key
/// `device`. Errors are stored in `reader`.
void readDeviceSettings(TableReader& reader, const std::string& file, const std::string& prefix,
                        ProjectCamera& camera);

/// Returns the keys `pixel_format`, `size` and `rate` as TOML; empty if no format is requested.
std::string deviceFormatText(const DeviceFormat& format);
/// Returns the tables [camera.identity] and [camera.controls] as TOML; empty if there is neither an
/// identity nor a control.
std::string deviceTablesText(const DeviceSettings& settings);

/// Checks the settings of a device. Error: BadValue, which names the key, for example "size".
Status checkDeviceSettings(const DeviceSettings& settings);

} // namespace dewpoint::project
