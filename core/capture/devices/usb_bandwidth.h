// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <cstddef>
#include <span>
#include <vector>

namespace dewpoint::capture {

/// A device and the format that is requested from it.
struct BandwidthRequest {
  CameraDevice device;
  DeviceFormat format; ///< parts that are left to the device: see completedFormat()
};

/// A format that needs less, for one of the requests.
struct BandwidthProposal {
  std::size_t request = 0; ///< index
  DeviceFormat format;
};

/// A USB bus that cannot carry what is requested from its devices.
struct BandwidthShortage {
  int bus = 0;                       ///< number of the bus
  std::vector<std::size_t> requests; ///< indices of the requests on this bus
  double needed = 0.0;               ///< bits per second
  double available = 0.0;            ///< bits per second
  /// Changes after which everything fits: compression at the same size and rate first, then a lower
  /// rate, then a smaller size. Empty if the devices offer no formats that fit.
  std::vector<BandwidthProposal> proposals;
};

/// Returns how many bits per second a format needs: all bytes of uncompressed images, and an
/// estimate for compressed ones. The format must be complete; 30 images per second are assumed if
/// it has no rate, and 0 is returned if it has no size.
double bitsPerSecond(const DeviceFormat& format);

/// Returns the buses that cannot carry what is requested, ordered by number. 80 % of the speed of a
/// bus (and of a device's own connection) is available for images. Devices that are not connected
/// by USB are ignored.
std::vector<BandwidthShortage> bandwidthShortages(std::span<const BandwidthRequest> requests);

} // namespace dewpoint::capture
