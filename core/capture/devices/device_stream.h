// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"
#include "core/capture/live_stream.h"

#include <cstddef>
#include <vector>

namespace dewpoint::capture {

/// What a connection needs to find its device among those that are present now.
struct DeviceLookup {
  DeviceAccessPtr access;
  /// Identities of all cameras that are open together, so that no two of them take the same device.
  std::vector<DeviceIdentity> identities;
  std::size_t camera = 0; ///< index of the camera in `identities`
};

/// Creates a connection that, each time it opens, finds the device by its identity, makes a
/// connection to it with `makeStream`, and sets the stored controls. A camera without identity
/// keeps its location. It does not open if the device is missing or ambiguous, or does not offer
/// the requested format. Controls that the device refuses are reported by remark().
LiveStreamPtr makeDeviceStream(const LiveCamera& camera, DeviceLookup lookup,
                               LiveStreamFactory makeStream);

} // namespace dewpoint::capture
