// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/device_access.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// What changes the colors of a camera by itself.
enum class ColorAutomatic { Exposure, Gain, WhiteBalance, Hue };

/// Result of lockColors().
struct ColorLock {
  /// An automatic that could not be switched off although the device has it, or a value that it
  /// does not let be set.
  struct Refusal {
    ColorAutomatic automatic = ColorAutomatic::Exposure;
    std::string control; ///< name of the control
    std::string reason;  ///< as text after a colon
  };

  /// All that is now set, to be stored in the project (DeviceSettings::controls): automatics that
  /// are off, and the values that hold instead.
  ControlValues values;
  std::vector<Refusal> refused;
  /// Exposure, gain or white balance, if the device has no control for it at all. Whether it
  /// adjusts itself is unknown.
  std::vector<ColorAutomatic> missing;
};

/// Switches the automatic exposure, gain, white balance and hue of a device off, and sets the
/// values that it reports at this time. The image changes if a device reports the last value set by
/// hand instead of the present one. Errors: DeviceUnavailable.
Result<ColorLock> lockColors(DeviceAccess& access, const std::string& path);

/// Sets stored controls, switches of automatics first, so that the others take effect.
/// Values that an automatic keeps are left out. Returns one error for each control that was not
/// set; `field` is its name. The others are set.
std::vector<Error> applyControls(DeviceAccess& access, const std::string& path,
                                 const ControlValues& values);

} // namespace dewpoint::capture
