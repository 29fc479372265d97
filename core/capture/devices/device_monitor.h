// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"

#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace dewpoint::capture {

using CameraDevices = std::vector<CameraDevice>;
using CameraDevicesPtr = std::shared_ptr<const CameraDevices>;

/// Reports in a separate thread which camera devices are connected.
class DeviceMonitor {
public:
  using Receiver = std::function<void(CameraDevicesPtr)>;

  /// Starts the monitor. It calls `receiver` in its own thread: first with the connected devices,
  /// then after each change. A change is noticed after at most `interval` plus the time that the
  /// drivers need.
  DeviceMonitor(DeviceAccessPtr access, Receiver receiver,
                std::chrono::milliseconds interval = std::chrono::milliseconds(500));
  DeviceMonitor(const DeviceMonitor&) = delete;
  DeviceMonitor& operator=(const DeviceMonitor&) = delete;
  /// Stops the monitor. Waits until the receiver has returned, but not for a driver. The receiver
  /// is not called afterwards. The receiver must not destroy the monitor.
  ~DeviceMonitor();

  /// Returns the newest list of devices without waiting for a driver; null before the first list is
  /// complete.
  CameraDevicesPtr latestDevices() const;

private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_; ///< also of the thread, which a driver may keep longer
  std::thread thread_;
};

} // namespace dewpoint::capture
