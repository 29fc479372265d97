// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"
#include "core/capture/devices/linux_calls.h"

#include <filesystem>

namespace dewpoint::capture {

/// Access to the V4L2 devices of a Linux system. The device nodes and their connections are read
/// from /sys/class/video4linux, and the stable paths from /dev/v4l. Everything else comes from the
/// drivers.
///
/// listDevices() omits nodes without video capture (metadata, outputs), codecs (M2M), nodes of a
/// media controller that must first be linked to a sensor (IO_MC), and nodes without any format.
class LinuxDevices final : public DeviceAccess {
public:
  /// `root` is the folder that contains dev and sys. On a running system, this is "/".
  explicit LinuxDevices(std::filesystem::path root = "/", LinuxCallsPtr calls = linuxCalls());

  std::vector<CameraDevice> listDevices() override;
  std::string deviceListSignature() override;
  Result<std::vector<DeviceControl>> readControls(const std::string& path) override;
  Status setControl(const std::string& path, const std::string& name, std::int64_t value) override;

private:
  /// Returns the path of a node below the root.
  std::string below(const std::string& path) const;

  std::filesystem::path root_;
  LinuxCallsPtr calls_;
};

} // namespace dewpoint::capture
