// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"
#include "core/capture/live_stream.h"

#include <cstddef>
#include <vector>

namespace dewpoint::capture {

/// Data with which the connection to a camera finds the camera's device among the connected
/// devices.
struct DeviceLookup {
  DeviceAccessPtr access;
  /// Identities of all cameras that are opened together. They ensure that no two cameras use the
  /// same device.
  std::vector<DeviceIdentity> identities;
  std::size_t cameraIndex = 0; ///< index of the camera in `identities`
};

/// Creates a connection that finds its device each time it is opened. open() finds the device by
/// its identity, connects to it with `makeStream`, and sets the stored controls. For a camera
/// without an identity, open() uses the camera's location. open() fails if the device is missing or
/// ambiguous, or does not offer the requested format. warning() reports the controls that the
/// device refused.
LiveStreamPtr makeDeviceStream(const LiveCamera& camera, DeviceLookup lookup,
                               LiveStreamFactory makeStream);

} // namespace dewpoint::capture
