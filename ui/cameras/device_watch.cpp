// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/device_watch.h"

#include <utility>

namespace dewpoint::ui {

DeviceWatch::DeviceWatch(capture::DeviceAccessPtr access, QObject* parent)
    : QObject(parent), access_(access != nullptr ? std::move(access) : capture::systemDevices()) {}

DeviceWatch::~DeviceWatch() = default;

void DeviceWatch::setDeviceAccess(capture::DeviceAccessPtr access) {
  const bool watches = monitor_ != nullptr;
  monitor_.reset();
  access_ = std::move(access);
  devices_ = std::make_shared<capture::CameraDevices>();
  listed_ = false;
  ++watches_;
  if (watches) {
    start();
  }
}

void DeviceWatch::start() {
  if (monitor_ != nullptr) {
    return;
  }
  const auto receive = [this, mailbox = mailbox_.sender(),
                        watch = watches_](const capture::CameraDevicesPtr& devices) {
    mailbox.post([this, watch, devices] {
      if (watch == watches_) {
        devices_ = devices;
        listed_ = true;
        Q_EMIT changed();
      }
    });
  };
  monitor_.reset(new capture::DeviceMonitor(access_, receive));
}

} // namespace dewpoint::ui
