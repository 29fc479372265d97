// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/jobs/job_thread.h"

#include <QObject>

#include <memory>

namespace dewpoint::ui {

/// The camera devices of this computer as they come and go. They are watched in other threads from
/// `start()` on, and reported in the GUI thread.
class DeviceWatch : public QObject {
  Q_OBJECT
public:
  /// `access`: the devices to watch; null: those of this computer.
  explicit DeviceWatch(capture::DeviceAccessPtr access = nullptr, QObject* parent = nullptr);
  ~DeviceWatch() override;

  /// Watches other devices than those of this computer, from now on.
  void setAccess(capture::DeviceAccessPtr access);
  /// Returns the devices for jobs: controls are read and set in their threads.
  const capture::DeviceAccessPtr& access() const { return access_; }
  /// Begins to watch, if that has not happened yet.
  void start();
  /// Returns whether the devices have been listed.
  bool isListed() const { return listed_; }
  /// Returns the present devices; empty before they have been listed.
  const capture::CameraDevices& devices() const { return *devices_; }

Q_SIGNALS:
  /// Emitted when the devices have been listed, and after each change.
  void changed();

private:
  capture::DeviceAccessPtr access_;
  capture::CameraDevicesPtr devices_ = std::make_shared<capture::CameraDevices>();
  bool listed_ = false;
  int watches_ = 0; ///< number of the newest monitor; lists of earlier ones are ignored
  JobMailbox mailbox_;
  std::unique_ptr<capture::DeviceMonitor> monitor_;
};

} // namespace dewpoint::ui
