// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::capture {

enum class ControlKind { Integer, Boolean, Menu };

/// Entry of a menu control.
struct ControlMenuItem {
  std::int64_t value = 0;
  std::string name; ///< of the driver: "Manual Mode"; or a number for a menu of integers

  bool operator==(const ControlMenuItem&) const = default;
};

/// A control of a camera device, such as its exposure time, with its present value.
struct DeviceControl {
  /// Name in project files, as v4l2-ctl shows it: "exposure_time_absolute". The same for all
  /// versions of the kernel.
  std::string name;
  std::string label; ///< of the driver: "Exposure Time, Absolute"
  ControlKind kind = ControlKind::Integer;
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;
  std::int64_t step = 1; ///< at least 1
  std::int64_t defaultValue = 0;
  std::int64_t value = 0;
  std::vector<ControlMenuItem> menu; ///< items that the device has; only for a menu
  bool readOnly = false;
  bool inactive = false; ///< has no effect now, because an automatic of the device sets it

  bool operator==(const DeviceControl&) const = default;
};

} // namespace dewpoint::capture
