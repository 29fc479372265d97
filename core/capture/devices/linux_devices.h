// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"
#include "core/capture/devices/linux_calls.h"

#include <filesystem>

namespace dewpoint::capture {

/// V4L2 devices: /sys/class/video4linux says which nodes there are and how they are connected,
/// /dev/v4l gives their stable paths, and the drivers answer for the rest.
///
/// Left out are nodes without video capture (metadata, outputs), codecs (M2M), nodes of a media
/// controller that must be linked to a sensor first (IO_MC), and nodes without any format.
class LinuxDevices final : public DeviceAccess {
public:
  /// `root` is the folder that contains dev and sys: "/" of a running system.
  explicit LinuxDevices(std::filesystem::path root = "/", LinuxCallsPtr calls = linuxCalls());

  std::vector<CameraDevice> list() override;
  std::string signature() override;
  Result<std::vector<DeviceControl>> controls(const std::string& path) override;
  Status setControl(const std::string& path, const std::string& name, std::int64_t value) override;

private:
  /// Path of a node below the root.
  std::string below(const std::string& path) const;

  std::filesystem::path root_;
  LinuxCallsPtr calls_;
};

} // namespace dewpoint::capture
