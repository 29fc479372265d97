// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// How a device was recognized.
enum class MatchBasis { None, Serial, Bus, Name };

/// Which of the present devices belongs to a camera.
struct DeviceMatch {
  std::optional<std::size_t> device; ///< index of the device; nothing if missing or ambiguous
  MatchBasis basis = MatchBasis::None;
  /// Devices among which only the user can decide; empty if one was found, or none is similar.
  std::vector<std::size_t> candidates;

  bool isAmbiguous() const { return !candidates.empty(); }
  bool isMissing() const { return !device && candidates.empty(); }
};

/// Finds the devices of several cameras among those that are present. No device is given to two
/// cameras.
///
/// 1. The same serial number decides, if only one device of this model has it.
/// 2. Else the same connector decides, if the model there is the same and no serial number differs.
///    Two equal devices without serial number stay apart in this way.
/// 3. Else the only remaining device of the same model is taken, if no serial number differs.
///
/// The model is the same if nothing differs that both sides know of vendor, product and name. If
/// several devices remain in step 3, several cameras claim the same one, or only the serial number
/// differs, the result is ambiguous. An empty identity is missing.
///
/// Two equal devices without serial number whose connectors were exchanged cannot be noticed.
///
/// Returns one match per identity, in their order.
std::vector<DeviceMatch> matchDevices(std::span<const DeviceIdentity> identities,
                                      std::span<const CameraDevice> devices);

/// Same for a single camera.
DeviceMatch matchDevice(const DeviceIdentity& identity, std::span<const CameraDevice> devices);

/// Returns why a match has no device, as text after a colon: the device that is missing, or the
/// candidates. Empty if it has one.
std::string mismatchReason(const DeviceMatch& match, const DeviceIdentity& identity,
                           std::span<const CameraDevice> devices);

} // namespace dewpoint::capture
