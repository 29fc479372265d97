// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/jobs/job_thread.h"

#include <QObject>

#include <memory>

namespace dewpoint::ui {

/// Watches which camera devices are connected to this computer. Devices are watched in other
/// threads from `start()` on; signals are emitted in the GUI thread. The GUI thread never waits for
/// a driver, nor for one of these threads.
class DeviceWatch : public QObject {
  Q_OBJECT
public:
  /// Creates an object that watches the devices of `access`; null: the devices of this computer.
  explicit DeviceWatch(capture::DeviceAccessPtr access = nullptr, QObject* parent = nullptr);
  ~DeviceWatch() override;

  /// Watches the devices of `access` from now on, instead of the devices of this computer.
  void setDeviceAccess(capture::DeviceAccessPtr access);
  /// Returns the access to the devices, with which jobs read and set controls in their own threads.
  const capture::DeviceAccessPtr& deviceAccess() const { return access_; }
  /// Starts to watch the devices. Does nothing if this was done before.
  void start();
  /// Returns whether the devices have been listed for the first time.
  bool areDevicesListed() const { return listed_; }
  /// Returns the connected devices; empty before areDevicesListed().
  const capture::CameraDevices& devices() const { return *devices_; }

Q_SIGNALS:
  /// Emitted when the devices have been listed for the first time, and after each change.
  void changed();

private:
  capture::DeviceAccessPtr access_;
  capture::CameraDevicesPtr devices_ = std::make_shared<capture::CameraDevices>();
  bool listed_ = false;
  int watches_ = 0; ///< number of the newest monitor; lists of earlier ones are ignored
  JobMailbox mailbox_;
  /// Destroyed in another thread, because the destructor joins the monitor's thread. Until then the
  /// monitor may still send lists: `mailbox_` drops them once this object is gone.
  std::unique_ptr<capture::DeviceMonitor, DetachedDeleter> monitor_;
};

} // namespace dewpoint::ui
