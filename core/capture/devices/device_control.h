// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Type of the value of a control: a number, a switch, or a choice from a menu.
enum class ControlKind { Integer, Boolean, Menu };

/// Choice in the menu of a control whose value is chosen from a menu.
struct ControlMenuItem {
  std::int64_t value = 0;
  /// Name given by the driver, such as "Manual Mode", or a number for a menu of integers.
  std::string name;

  bool operator==(const ControlMenuItem&) const = default;
};

/// Control of a camera device, such as its exposure time, with its current value.
struct DeviceControl {
  /// Name in project files, as in v4l2-ctl: "exposure_time_absolute". It is the same for all kernel
  /// versions.
  std::string name;
  std::string label; ///< name given by the driver, for example "Exposure Time, Absolute"
  ControlKind kind = ControlKind::Integer;
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;
  std::int64_t step = 1; ///< distance between two possible values, at least 1
  std::int64_t defaultValue = 0;
  std::int64_t value = 0;
  std::vector<ControlMenuItem>
      menuItems; ///< choices that the device offers; only for ControlKind::Menu
  bool isReadOnly = false;
  bool isInactive =
      false; ///< has no effect now, because the device adjusts this value automatically

  bool operator==(const DeviceControl&) const = default;
};

} // namespace dewpoint::capture
