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

/// Reports camera devices as they come and go, from its own thread.
class DeviceMonitor {
public:
  using Receiver = std::function<void(CameraDevicesPtr)>;

  /// Calls `receiver` in the monitor's thread: first with the present devices, then after each
  /// change. Changes are seen within `interval` and the time that the drivers need.
  DeviceMonitor(DeviceAccessPtr access, Receiver receiver,
                std::chrono::milliseconds interval = std::chrono::milliseconds(500));
  DeviceMonitor(const DeviceMonitor&) = delete;
  DeviceMonitor& operator=(const DeviceMonitor&) = delete;
  /// Waits for a call of the receiver that is under way, but not for a driver. The receiver is not
  /// called afterwards. Not to be called by the receiver.
  ~DeviceMonitor();

  /// Returns the newest list without waiting for a driver; null before the first.
  CameraDevicesPtr latest() const;

private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_; ///< also of the thread, which a driver may keep longer
  std::thread thread_;
};

} // namespace dewpoint::capture
