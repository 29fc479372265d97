// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <cstddef>
#include <span>
#include <vector>

namespace dewpoint::capture {

/// A device, and the format that is requested from it.
struct BandwidthRequest {
  CameraDevice device;
  /// Requested format; completedFormat() fills in the parts that are left to the device.
  DeviceFormat format;
};

/// Format that needs less bandwidth, proposed for one of the requests.
struct BandwidthProposal {
  std::size_t requestIndex = 0; ///< index of the request
  DeviceFormat format;
};

/// USB bus that is too slow for the formats requested from its devices.
struct BandwidthShortage {
  int busNumber = 0;                       ///< number of the bus
  std::vector<std::size_t> requestIndices; ///< indices of the requests on this bus
  double neededBitsPerSecond = 0.0;        ///< bandwidth of the requested formats, bits per second
  double availableBitsPerSecond = 0.0;     ///< bandwidth available for images, bits per second
  /// Changes after which the bus is fast enough. A compressed format at the same size and rate is
  /// preferred to a lower rate, and a lower rate to a smaller size. Empty if no offered formats
  /// would fit.
  std::vector<BandwidthProposal> proposals;
};

/// Returns the bandwidth that a format needs, in bits per second. For compressed formats, it is an
/// estimate. If the format has no rate, 30 images per second are assumed. Returns 0 if the format
/// has no size.
double bitsPerSecond(const DeviceFormat& format);

/// Returns the USB buses that are too slow for the requests, ordered by number. It is assumed that
/// 80 % of the speed of a bus, and of each device's own connection, is available for images.
/// Devices that are not connected by USB are ignored.
std::vector<BandwidthShortage> findBandwidthShortages(std::span<const BandwidthRequest> requests);

} // namespace dewpoint::capture
