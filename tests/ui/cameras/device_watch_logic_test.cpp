// SPDX-License-Identifier: GPL-3.0-or-later
// A driver that does not answer: who drops or redirects the watch over the devices does not wait. A
// watch that waits for its threads never gets to the end of these tests.
#include "tests/ui/cameras/fake_devices.h"
#include "tests/ui/gate.h"
#include "tests/ui/wait.h"
#include "ui/cameras/device_watch.h"
#include "ui/jobs/job_thread.h"

#include <QCoreApplication>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

/// A webcam that is listed only once the gate is open.
class DeadDriver final : public capture::DeviceAccess {
public:
  explicit DeadDriver(std::shared_ptr<test::Gate> gate) : gate_(std::move(gate)) {}

  std::vector<capture::CameraDevice> listDevices() override {
    gate_->pass();
    return {test::fakeWebcam(1, "dead")};
  }
  std::string deviceListSignature() override { return "the same"; }
  Result<std::vector<capture::DeviceControl>> readControls(const std::string& path) override {
    return failure(ErrorCode::DeviceUnavailable, path, "", "");
  }
  Status setControl(const std::string& path, const std::string&, std::int64_t) override {
    return failure(ErrorCode::DeviceUnavailable, path, "", "");
  }

private:
  std::shared_ptr<test::Gate> gate_;
};

class WatchOfADeadDriver : public testing::Test, protected test::Waiting {
protected:
  WatchOfADeadDriver() {
    auto driver = std::make_shared<DeadDriver>(gate_);
    driver_ = driver;
    watch_ = std::make_unique<DeviceWatch>(std::move(driver));
    QObject::connect(watch_.get(), &DeviceWatch::changed, [heard = heard_] { ++*heard; });
    watch_->start();
  }
  ~WatchOfADeadDriver() override {
    watch_.reset();
    answer();
  }
  bool hangs() const {
    return waitFor([this] { return gate_->waiting() == 1; });
  }
  /// Lets the driver answer, and waits until all threads that asked it are gone.
  bool answer() const {
    gate_->open();
    const bool gone = waitFor(
        [this] { return driver_.expired() && waitForDetachedJobs(std::chrono::milliseconds(0)); });
    QCoreApplication::processEvents(); // what they have posted
    return gone;
  }

  std::shared_ptr<test::Gate> gate_ = std::make_shared<test::Gate>();
  std::shared_ptr<int> heard_ = std::make_shared<int>(0); ///< lists that the watch has received
  std::weak_ptr<DeadDriver> driver_;
  std::unique_ptr<DeviceWatch> watch_;
};

TEST_F(WatchOfADeadDriver, IsDroppedBeforeTheDriverAnswers) {
  ASSERT_TRUE(hangs());
  watch_.reset();
  EXPECT_EQ(gate_->waiting(), 1); // until here, nothing has moved
  EXPECT_TRUE(answer());
  EXPECT_EQ(*heard_, 0);
}

TEST_F(WatchOfADeadDriver, WatchesOtherDevicesBeforeTheDriverAnswers) {
  ASSERT_TRUE(hangs());
  const auto devices = std::make_shared<test::FakeDevices>();
  devices->plug(test::fakeWebcam(2, "alive"));
  watch_->setDeviceAccess(devices);
  ASSERT_TRUE(waitFor([this] { return watch_->areDevicesListed(); }));
  EXPECT_EQ(gate_->waiting(), 1);
  EXPECT_TRUE(answer());
  EXPECT_EQ(*heard_, 1); // the late answer is for nobody
  ASSERT_EQ(watch_->devices().size(), 1U);
  EXPECT_EQ(watch_->devices()[0].identity.serial, "alive");
}

} // namespace
} // namespace dewpoint::tests
