// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/device_settings.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Image size that a device offers, and the frame rates at this size.
struct OfferedSize {
  int width = 0;  ///< pixels
  int height = 0; ///< pixels
  /// Images per second, highest first; empty if the device does not list rates.
  std::vector<double> frameRates;

  bool operator==(const OfferedSize&) const = default;
};

/// Pixel format that a device offers, and the image sizes in this format.
struct OfferedFormat {
  std::string pixelFormat;        ///< V4L2 four-character code, for example "MJPG"
  std::string description;        ///< name given by the driver, for example "Motion-JPEG"
  bool isCompressed = false;      ///< true if the images are compressed
  std::vector<OfferedSize> sizes; ///< image sizes, largest first

  /// True if the device accepts a range of sizes. `sizes` then contains only the common sizes in
  /// this range.
  bool hasOtherSizes = false;

  bool operator==(const OfferedFormat&) const = default;
};

/// USB bus to which a device is connected. Devices with the same bus number share the capacity of
/// the bus.
struct UsbLink {
  int busNumber = 0;                ///< number of the bus; 0 if the device is not a USB device
  double deviceMbitPerSecond = 0.0; ///< speed of the device, Mbit/s: 12, 480, 5000, ...
  double busMbitPerSecond = 0.0;    ///< speed of the bus, Mbit/s

  bool operator==(const UsbLink&) const = default;
};

/// A camera device that is connected to this computer.
struct CameraDevice {
  /// Device node, for example "/dev/video0"; may change when devices are plugged in.
  std::string path;
  /// Path that does not change when devices are plugged in; can be used as LiveCamera::location. It
  /// is below /dev/v4l/by-id if the serial number is unique, otherwise below /dev/v4l/by-path. If
  /// there is neither, it is `path`.
  std::string stablePath;
  DeviceIdentity identity;
  std::string driver; ///< kernel driver, for example "uvcvideo"
  UsbLink usbLink;
  std::vector<OfferedFormat> formats;
  /// Reason why the device cannot be used, for example a missing permission. `formats` is then
  /// empty. The text is empty if the device can be used.
  std::string problem;

  bool operator==(const CameraDevice&) const = default;
};

/// Returns a description of a device for messages: its name and serial number, or its name and
/// connector if it has no serial number.
std::string describe(const DeviceIdentity& identity);

/// Returns a format as text, for example "MJPG 1280x720 30". Omits the parts that are left to the
/// device.
std::string describe(const DeviceFormat& format);

/// Returns a requested format, with the parts that are left to the device filled in as openLive()
/// would choose them: JPEG if it is offered at the requested size and rate, then the largest size,
/// then the highest rate. Parts that are requested are not changed, even if the device does not
/// offer them.
DeviceFormat completedFormat(const DeviceFormat& format, const std::vector<OfferedFormat>& offered);

/// Returns whether a device offers a format. Parts of the format that are left to the device are
/// not compared. Rates may differ by 1 %.
bool isOffered(const DeviceFormat& format, const std::vector<OfferedFormat>& offered);

} // namespace dewpoint::capture
