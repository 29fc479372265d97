// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_monitor.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace dewpoint::capture {
namespace {

/// Intervals after which a device that could not be used is tried again.
constexpr int kRetryIntervals = 4;

bool hasUnusable(const CameraDevices& devices) {
  return std::ranges::any_of(devices, [](const CameraDevice& one) { return !one.problem.empty(); });
}

} // namespace

struct DeviceMonitor::Shared {
  DeviceAccessPtr access;
  std::chrono::milliseconds interval{};

  std::mutex receiving; ///< held while the receiver is called; never together with `mutex`
  Receiver receiver;    ///< guarded by `receiving`

  mutable std::mutex mutex; ///< guards all members below
  std::condition_variable changed;
  bool stopped = false;
  bool asksDrivers = false;
  CameraDevicesPtr latest;

  /// Marks the start or the end of calls to drivers. Returns whether the monitor goes on.
  bool setAsking(bool asks) {
    std::scoped_lock lock(mutex);
    asksDrivers = asks && !stopped;
    return !stopped;
  }

  /// Waits for one interval. Returns whether the monitor goes on.
  bool pause() {
    std::unique_lock lock(mutex);
    return !changed.wait_for(lock, interval, [&] { return stopped; });
  }

  void publish(CameraDevices devices) {
    auto list = std::make_shared<const CameraDevices>(std::move(devices));
    {
      std::scoped_lock lock(mutex);
      if (latest && *latest == *list) {
        return;
      }
      latest = list;
    }
    std::scoped_lock lock(receiving);
    if (receiver) {
      receiver(std::move(list));
    }
  }
};

DeviceMonitor::DeviceMonitor(DeviceAccessPtr access, Receiver receiver,
                             std::chrono::milliseconds interval)
    : shared_(std::make_shared<Shared>()) {
  shared_->access = std::move(access);
  shared_->interval = interval;
  shared_->receiver = std::move(receiver);
  thread_ = std::thread([shared = shared_] { run(shared); });
}

DeviceMonitor::~DeviceMonitor() {
  {
    std::scoped_lock lock(shared_->receiving);
    shared_->receiver = nullptr;
  }
  bool inDriver = false;
  {
    std::scoped_lock lock(shared_->mutex);
    shared_->stopped = true;
    inDriver = shared_->asksDrivers;
  }
  shared_->changed.notify_all();
  if (inDriver) {
    thread_.detach(); // ends with the driver's answer
  } else {
    thread_.join();
  }
}

CameraDevicesPtr DeviceMonitor::latestDevices() const {
  std::scoped_lock lock(shared_->mutex);
  return shared_->latest;
}

void DeviceMonitor::run(const std::shared_ptr<Shared>& shared) {
  std::optional<std::string> known;
  int retryIn = 0; // intervals; 0: no device waits for it
  do {
    if (!shared->setAsking(true)) {
      return;
    }
    // Before the list: what changes in between is seen at the next time.
    std::string signature = shared->access->deviceListSignature();
    const bool retries = retryIn == 1;
    retryIn = std::max(retryIn - 1, 0);
    std::optional<CameraDevices> devices;
    if (retries || signature != known) {
      known = std::move(signature);
      devices = shared->access->listDevices();
      retryIn = hasUnusable(*devices) ? kRetryIntervals : 0;
    }
    if (!shared->setAsking(false)) {
      return;
    }
    if (devices) {
      shared->publish(std::move(*devices));
    }
  } while (shared->pause());
}

} // namespace dewpoint::capture
