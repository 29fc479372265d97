// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_monitor.h"
#include "tests/capture/devices/fake_machine.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <deque>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;

/// Lists received from a monitor, in order.
class ReceivedLists {
public:
  DeviceMonitor::Receiver receiver() {
    return [this](CameraDevicesPtr list) {
      std::scoped_lock lock(mutex_);
      lists_.push_back(std::move(list));
      arrived_.notify_all();
    };
  }
  /// The next list; null if none comes in a long time.
  CameraDevicesPtr next() {
    std::unique_lock lock(mutex_);
    if (!arrived_.wait_for(lock, 30s, [&] { return !lists_.empty(); })) {
      return nullptr;
    }
    auto list = std::move(lists_.front());
    lists_.pop_front();
    return list;
  }

private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<CameraDevicesPtr> lists_;
};

FakeNode monitoredCamera(const std::string& name, const std::string& port) {
  FakeNode node;
  node.name = name;
  node.port = port;
  node.formats = {fakeMjpg()};
  return node;
}

/// Waits for a list of devices at these paths. While a device is plugged in, it may be seen in
/// part.
testing::AssertionResult reports(ReceivedLists& lists, const std::vector<std::string>& paths) {
  for (;;) {
    const auto list = lists.next();
    if (!list) {
      return testing::AssertionFailure() << "no such list";
    }
    std::vector<std::string> found;
    for (const CameraDevice& device : *list) {
      found.push_back(device.path);
    }
    if (found == paths) {
      return testing::AssertionSuccess();
    }
  }
}

TEST(DeviceMonitor, ReportsWhatComesAndGoes) {
  const auto machine = std::make_shared<FakeMachine>();
  machine->plug(monitoredCamera("video0", "3"));
  ReceivedLists lists;
  const DeviceMonitor monitor(accessTo(machine), lists.receiver(), 5ms);
  EXPECT_TRUE(reports(lists, {"/dev/video0"}));
  machine->plug(monitoredCamera("video2", "4"));
  EXPECT_TRUE(reports(lists, {"/dev/video0", "/dev/video2"}));
  machine->unplug("video0");
  EXPECT_TRUE(reports(lists, {"/dev/video2"}));
  machine->unplug("video2");
  EXPECT_TRUE(reports(lists, {}));
  EXPECT_TRUE(monitor.latestDevices()->empty());
}

TEST(DeviceMonitor, TriesUnusableDevicesAgain) {
  const auto machine = std::make_shared<FakeMachine>();
  FakeNode node = monitoredCamera("video0", "3");
  node.openError = EBUSY;
  machine->plug(node);
  ReceivedLists lists;
  const DeviceMonitor monitor(accessTo(machine), lists.receiver(), 5ms);
  const auto busy = lists.next();
  ASSERT_TRUE(busy);
  ASSERT_EQ(busy->size(), 1U);
  EXPECT_NE(busy->at(0).problem, "");
  machine->setOpenError("video0", 0); // nothing below /dev changes by this
  const auto usable = lists.next();
  ASSERT_TRUE(usable);
  EXPECT_EQ(usable->at(0).problem, "");
}

/// Devices whose driver does not answer until it is released.
class StuckAccess final : public DeviceAccess {
public:
  std::vector<CameraDevice> listDevices() override {
    asked = true;
    while (!released) {
      std::this_thread::sleep_for(1ms);
    }
    answered = true;
    return {CameraDevice{}};
  }
  std::string deviceListSignature() override { return "one"; }
  Result<std::vector<DeviceControl>> readControls(const std::string& /*path*/) override {
    return {};
  }
  Status setControl(const std::string& /*path*/, const std::string& /*name*/,
                    std::int64_t /*value*/) override {
    return {};
  }

  std::atomic<bool> asked{false};
  std::atomic<bool> released{false};
  std::atomic<bool> answered{false};
};

TEST(DeviceMonitor, EndsWithoutTheDriver) {
  const auto access = std::make_shared<StuckAccess>();
  std::atomic<int> calls = 0;
  {
    const DeviceMonitor monitor(
        access, [&](const CameraDevicesPtr&) { ++calls; }, 5ms);
    while (!access->asked) {
      std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(monitor.latestDevices(), nullptr);
  } // does not wait
  EXPECT_FALSE(access->answered);
  access->released = true;
  while (access.use_count() > 1) { // the thread is at its end
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(access->answered);
  EXPECT_EQ(calls, 0);
}

} // namespace
} // namespace dewpoint::tests
