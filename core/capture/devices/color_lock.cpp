// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/color_lock.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace dewpoint::capture {
namespace {

/// A control that belongs to an automatic of the device.
struct ColorControl {
  ColorAutomatic automatic;
  const char* name;
  std::optional<std::int64_t> off; ///< value that switches the automatic off; nothing: its value
};

// V4L2_EXPOSURE_MANUAL is 1; the automatics of white balance and ISO have "manual" at 0.
const std::array<ColorControl, 18> kColorControls{{
    {ColorAutomatic::Exposure, "auto_exposure", 1},
    {ColorAutomatic::Exposure, "exposure_dynamic_framerate", 0},
    {ColorAutomatic::Exposure, "brightness_automatic", 0},
    {ColorAutomatic::Exposure, "exposure_time_absolute", std::nullopt},
    {ColorAutomatic::Exposure, "exposure", std::nullopt},
    {ColorAutomatic::Exposure, "brightness", std::nullopt},
    {ColorAutomatic::Gain, "gain_automatic", 0},
    {ColorAutomatic::Gain, "iso_sensitivity_auto", 0},
    {ColorAutomatic::Gain, "gain", std::nullopt},
    {ColorAutomatic::Gain, "analogue_gain", std::nullopt},
    {ColorAutomatic::Gain, "iso_sensitivity", std::nullopt},
    {ColorAutomatic::WhiteBalance, "white_balance_automatic", 0},
    {ColorAutomatic::WhiteBalance, "white_balance_auto_preset", 0},
    {ColorAutomatic::WhiteBalance, "white_balance_temperature", std::nullopt},
    {ColorAutomatic::WhiteBalance, "red_balance", std::nullopt},
    {ColorAutomatic::WhiteBalance, "blue_balance", std::nullopt},
    {ColorAutomatic::Hue, "hue_automatic", 0},
    {ColorAutomatic::Hue, "hue", std::nullopt},
}};

const DeviceControl* controlNamed(const std::vector<DeviceControl>& controls,
                                  std::string_view name) {
  const auto found = std::ranges::find(controls, name, &DeviceControl::name);
  return found == controls.end() ? nullptr : &*found;
}

bool isRefused(const ColorLock& lock, ColorAutomatic automatic) {
  return std::ranges::find(lock.refusals, automatic, &ColorLock::Refusal::adjustment) !=
         lock.refusals.end();
}

/// Sets one control, and keeps why the device refused it. Fails if the device is gone.
Status setOne(DeviceAccess& access, const std::string& path, const ColorControl& one,
              std::int64_t value, ColorLock& lock) {
  auto set = access.setControl(path, one.name, value);
  if (set) {
    lock.values[one.name] = value;
  } else if (set.error().code == ErrorCode::DeviceUnavailable) {
    return set;
  } else {
    // A value cannot be set while its automatic is on: that it is on has been said.
    if (one.off || !isRefused(lock, one.automatic)) {
      lock.refusals.push_back({one.automatic, one.name, set.error().detail});
    }
  }
  return {};
}

/// Switches automatics off (`switches`) or sets the values that hold instead, and reads back what
/// the device has now: it rounds values, and may ignore a switch.
Status lockStep(DeviceAccess& access, const std::string& path, bool switches,
                const std::vector<DeviceControl>& before, ColorLock& lock) {
  for (const ColorControl& one : kColorControls) {
    const DeviceControl* control = controlNamed(before, one.name);
    if (one.off.has_value() != switches || control == nullptr || control->isReadOnly) {
      continue;
    }
    if (auto set = setOne(access, path, one, one.off.value_or(control->value), lock); !set) {
      return set;
    }
  }
  const auto after = access.readControls(path);
  if (!after) {
    return tl::make_unexpected(after.error());
  }
  for (const ColorControl& one : kColorControls) {
    const DeviceControl* control = controlNamed(*after, one.name);
    const auto kept = lock.values.find(one.name);
    if (control == nullptr || kept == lock.values.end()) {
      continue;
    }
    kept->second = control->value;
    if (one.off && control->value != *one.off) {
      lock.values.erase(kept);
      lock.refusals.push_back({one.automatic, one.name, "the device does not switch it off"});
    }
  }
  return {};
}

bool isSwitch(const std::string& name) {
  return name.find("auto") != std::string::npos;
}

} // namespace

Result<ColorLock> lockColors(DeviceAccess& access, const std::string& path) {
  const auto before = access.readControls(path);
  if (!before) {
    return tl::make_unexpected(before.error());
  }
  ColorLock lock;
  for (const bool switches : {true, false}) {
    if (const auto done = lockStep(access, path, switches, *before, lock); !done) {
      return tl::make_unexpected(done.error());
    }
  }
  for (const auto automatic :
       {ColorAutomatic::Exposure, ColorAutomatic::Gain, ColorAutomatic::WhiteBalance}) {
    if (std::ranges::none_of(kColorControls, [&](const ColorControl& one) {
          return one.automatic == automatic && controlNamed(*before, one.name) != nullptr;
        })) {
      lock.missingControls.push_back(automatic);
    }
  }
  return lock;
}

std::vector<Error> applyControls(DeviceAccess& access, const std::string& path,
                                 const ControlValues& values) {
  std::vector<Error> errors;
  std::vector<std::pair<std::string, std::int64_t>> ordered(values.begin(), values.end());
  const auto others = std::stable_partition(ordered.begin(), ordered.end(),
                                            [](const auto& one) { return isSwitch(one.first); });
  const auto set = [&](const auto& one) {
    if (auto done = access.setControl(path, one.first, one.second); !done) {
      errors.push_back(std::move(done.error()));
    }
  };
  std::for_each(ordered.begin(), others, set);
  if (others == ordered.end()) {
    return errors;
  }
  const auto controls = access.readControls(path);
  for (auto one = others; one != ordered.end(); ++one) {
    const DeviceControl* control = controls ? controlNamed(*controls, one->first) : nullptr;
    if (control == nullptr || !control->isInactive) { // an automatic that stays on has its value
      set(*one);
    }
  }
  return errors;
}

} // namespace dewpoint::capture
