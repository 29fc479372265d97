// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Property by which a device was recognized.
enum class MatchBasis { None, Serial, Bus, Name };

/// Result of searching for a camera's device among the connected devices.
struct DeviceMatch {
  /// Index of the camera's device in the list of connected devices; empty if the device is missing
  /// or ambiguous.
  std::optional<std::size_t> deviceIndex;
  MatchBasis basis = MatchBasis::None;
  /// Indices of similar devices, if it is not clear which one belongs to the camera; the user must
  /// choose. Empty if a device was found, or if none is similar.
  std::vector<std::size_t> candidateIndices;

  bool isAmbiguous() const { return !candidateIndices.empty(); }
  bool isMissing() const { return !deviceIndex && candidateIndices.empty(); }
};

/// Finds the connected device of each camera by its identity. Returns one match per identity, in
/// the same order. No device is assigned to two cameras.
///
/// The rules are tried in this order:
///
/// 1. The device has the same serial number and model, and no other device of this model has this
///    serial number.
/// 2. The device is at the same connector, has the same model, and has no different serial number.
///    This distinguishes two identical devices without serial numbers.
/// 3. The device is the only remaining one of the same model, and has no different serial number.
///
/// Two models are the same if they agree in all of vendor, product and name that are known for
/// both. The result is ambiguous if several devices remain for rule 3, if several cameras match the
/// same device, or if only the serial number differs. A camera with an empty identity has no
/// device.
///
/// If two identical devices without serial numbers exchanged their connectors, this cannot be
/// detected.
std::vector<DeviceMatch> matchDevices(std::span<const DeviceIdentity> identities,
                                      std::span<const CameraDevice> devices);

/// Finds the connected device of a single camera by its identity. The rules are those of
/// matchDevices(): first by serial number, then by connector, then by model.
DeviceMatch matchDevice(const DeviceIdentity& identity, std::span<const CameraDevice> devices);

/// Returns why no device was found for a camera (`match`): the device is missing, or there are
/// several candidates. The text can be appended after a colon. It is empty if the match has a
/// device.
std::string mismatchReason(const DeviceMatch& match, const DeviceIdentity& identity,
                           std::span<const CameraDevice> devices);

} // namespace dewpoint::capture
