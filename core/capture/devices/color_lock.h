// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/device_access.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Automatic adjustments of a camera that change its colors.
enum class ColorAutomatic { Exposure, Gain, WhiteBalance, Hue };

/// Result of switching off the automatic color adjustments of a device; see lockColors().
struct ColorLock {
  /// Control that the device did not accept: an automatic adjustment that could not be switched
  /// off, or a value that could not be set.
  struct Refusal {
    ColorAutomatic adjustment = ColorAutomatic::Exposure;
    std::string controlName; ///< name of the control
    std::string reason;      ///< reason for the refusal, as text to append after a colon
  };

  /// Control values that are now set, to be stored in the project (DeviceSettings::controls): the
  /// switches of automatic adjustments that are off, and the fixed values.
  ControlValues values;
  std::vector<Refusal> refusals; ///< controls that the device did not accept
  /// Adjustments of exposure, gain or white balance for which the device has no control. It is not
  /// known whether the device adjusts them automatically.
  std::vector<ColorAutomatic> missingControls;
};

/// Switches off the automatic exposure, gain, white balance and hue of a device. Then sets the
/// values that the device reported before. The image may change, because some devices report the
/// last value set by hand instead of the current one. Error: DeviceUnavailable.
Result<ColorLock> lockColors(DeviceAccess& access, const std::string& path);

/// Sets stored control values. Switches of automatic adjustments are set first, because they
/// determine which other controls take effect. Values that an automatic adjustment still controls
/// are skipped. Returns one error for each control that could not be set; Error::field is the name
/// of the control. All other controls are set.
std::vector<Error> applyControls(DeviceAccess& access, const std::string& path,
                                 const ControlValues& values);

} // namespace dewpoint::capture
