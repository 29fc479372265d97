// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/device_settings.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Image size that a device offers, with its rates.
struct OfferedSize {
  int width = 0;             ///< pixels
  int height = 0;            ///< pixels
  std::vector<double> rates; ///< images per second, highest first; empty if the device names none

  bool operator==(const OfferedSize&) const = default;
};

/// Pixel format that a device offers, with its sizes.
struct OfferedFormat {
  std::string pixelFormat;        ///< as in DeviceFormat: "MJPG"
  std::string description;        ///< of the driver, for example "Motion-JPEG"
  bool isCompressed = false;      ///< fewer bytes than its pixels would need
  std::vector<OfferedSize> sizes; ///< largest first

  /// The device accepts a range of sizes, of which `sizes` has the usual ones.
  bool hasOtherSizes = false;

  bool operator==(const OfferedFormat&) const = default;
};

/// USB bus that a device is connected to. Devices with the same bus number share its capacity.
struct UsbLink {
  int bus = 0;             ///< number of the bus; 0: not a USB device
  double deviceMbit = 0.0; ///< speed of the device, Mbit/s: 12, 480, 5000, ...
  double busMbit = 0.0;    ///< speed of the bus, Mbit/s

  bool operator==(const UsbLink&) const = default;
};

/// A camera device that is connected to this computer.
struct CameraDevice {
  std::string path; ///< device node, which changes with the order of plugging: "/dev/video0"
  /// Path that stays the same: below /dev/v4l/by-id if the serial number is unique, else below
  /// /dev/v4l/by-path, else `path`. A LiveCamera can have it as its location.
  std::string address;
  DeviceIdentity identity;
  std::string driver; ///< kernel driver, for example "uvcvideo"
  UsbLink usb;
  std::vector<OfferedFormat> formats;
  /// Why the device cannot be used, such as missing permission; empty if it can be. Then it has no
  /// formats.
  std::string problem;

  bool operator==(const CameraDevice&) const = default;
};

/// Returns the device in words that distinguish it from others: name and serial number, or name and
/// connector if it has no serial number.
std::string describe(const DeviceIdentity& identity);

/// Returns the format as text: "MJPG 1280x720 30". Parts that are left to the device are left out.
std::string describe(const DeviceFormat& format);

/// Returns the format that a request leads to: parts that were left to the device become those that
/// open_live prefers (a compressed format if it has the requested size and rate, and its largest
/// size and highest rate). Parts that the device does not offer are unchanged.
DeviceFormat completedFormat(const DeviceFormat& format, const std::vector<OfferedFormat>& offered);

/// Returns whether a device offers a format, as far as its parts are given. Rates may differ by 1
/// %.
bool isOffered(const DeviceFormat& format, const std::vector<OfferedFormat>& offered);

} // namespace dewpoint::capture
