// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_stream.h"
#include "core/capture/gstreamer/open_live.h"
#include "tests/capture/devices/fake_machine.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <functional>
#include <memory>

namespace dewpoint::tests {
namespace {

/// A connection that only remembers where it went.
class RememberedStream final : public LiveStream {
public:
  RememberedStream(std::string location, std::shared_ptr<std::string> opened)
      : location_(std::move(location)), opened_(std::move(opened)) {}
  tl::expected<void, std::string> open() override {
    *opened_ = location_;
    return {};
  }
  bool grab() override { return true; }
  cv::Mat retrieve() override { return cv::Mat::zeros(4, 4, CV_8UC3); }

private:
  std::string location_;
  std::shared_ptr<std::string> opened_;
};

/// A connection during whose opening something happens, and whose images arrive at a known time.
class EventfulStream final : public LiveStream {
public:
  explicit EventfulStream(std::function<void()> event) : event_(std::move(event)) {}
  tl::expected<void, std::string> open() override {
    event_();
    return {};
  }
  bool grab() override { return true; }
  cv::Mat retrieve() override { return cv::Mat::zeros(4, 4, CV_8UC3); }
  std::optional<std::chrono::steady_clock::time_point> arrivalTime() const override {
    return kArrival;
  }

  static constexpr std::chrono::steady_clock::time_point kArrival{std::chrono::seconds(7)};

private:
  std::function<void()> event_;
};

/// Two equal webcams without serial numbers at the ports 3 and 4, and cameras that know them.
class DeviceStreamTest : public testing::Test {
protected:
  DeviceStreamTest() {
    plugAs("video0", "3");
    plugAs("video2", "4");
    for (const CameraDevice& device : access_->listDevices()) {
      identities_.push_back(device.identity);
    }
  }

  void plugAs(const std::string& name, const std::string& port) {
    FakeNode node;
    node.name = name;
    node.port = port;
    node.formats = {fakeMjpg(), fakeYuyv()};
    node.controls = fakeControls();
    machine_->plug(node);
  }

  LiveCamera cameraAt(std::size_t camera) const {
    LiveCamera live;
    live.name = camera == 0 ? "left" : "right";
    live.location = "/dev/video0";
    live.device.identity = identities_.at(camera);
    return live;
  }

  LiveStreamPtr streamOf(std::size_t camera, DeviceFormat format = {},
                         ControlValues controls = {}) {
    LiveCamera live = cameraAt(camera);
    live.device.format = std::move(format);
    live.device.controls = std::move(controls);
    return makeDeviceStream(live, {access_, identities_, camera}, [this](const LiveCamera& found) {
      return std::make_unique<RememberedStream>(found.location, opened_);
    });
  }

  /// The stream of the left camera, during whose opening something happens.
  LiveStreamPtr eventfulStream(const std::function<void()>& event) {
    LiveCamera live = cameraAt(0);
    live.device.controls = {{"gain", 7}};
    return makeDeviceStream(live, {access_, identities_, 0}, [event](const LiveCamera&) {
      return std::make_unique<EventfulStream>(event);
    });
  }

  std::shared_ptr<FakeMachine> machine_ = std::make_shared<FakeMachine>();
  DeviceAccessPtr access_ = accessTo(machine_);
  std::vector<DeviceIdentity> identities_;
  std::shared_ptr<std::string> opened_ = std::make_shared<std::string>();
};

TEST_F(DeviceStreamTest, FollowsTheDeviceToItsNewNumber) {
  const auto left = streamOf(0);
  ASSERT_TRUE(left->open());
  EXPECT_EQ(*opened_, "/dev/video0");
  // As after a restart: the other order.
  machine_->unplug("video0");
  machine_->unplug("video2");
  plugAs("video0", "4");
  plugAs("video1", "3");
  ASSERT_TRUE(left->open());
  EXPECT_EQ(*opened_, "/dev/video1");
  ASSERT_TRUE(streamOf(1)->open());
  EXPECT_EQ(*opened_, "/dev/video0");
}

TEST_F(DeviceStreamTest, NamesTheMissingDevice) {
  machine_->unplug("video0");
  const auto opened = streamOf(0)->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error(),
            "'HD Webcam' (connector pci-0000:00:14.0-usb-0:3:1.0) is not connected");
  EXPECT_EQ(*opened_, ""); // the other twin is not taken
  EXPECT_TRUE(streamOf(1)->open());
}

TEST_F(DeviceStreamTest, AsksWhenTheTwinsWereMoved) {
  machine_->unplug("video0");
  machine_->unplug("video2");
  plugAs("video0", "7");
  plugAs("video2", "8");
  const auto opened = streamOf(0)->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("not certain"), std::string::npos) << opened.error();
}

TEST_F(DeviceStreamTest, RefusesAFormatThatIsNotOffered) {
  EXPECT_TRUE(streamOf(0, {"MJPG", 1280, 720, 30.0})->open());
  const auto opened = streamOf(0, {"YUYV", 1280, 720, 30.0})->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("does not offer the format YUYV 1280x720 30; it offers MJPG "
                                "1280x720 30, for example"),
            std::string::npos)
      << opened.error();
}

TEST_F(DeviceStreamTest, SetsControlsEachTimeItOpens) {
  const auto stream = streamOf(1, {}, {{"gain", 7}, {"zoom_absolute", 1}});
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(stream->open());
    EXPECT_EQ(machine_->valueOf("video2", V4L2_CID_GAIN), 7);
    ASSERT_TRUE(access_->setControl("/dev/video2", "gain", 64));
  }
  EXPECT_EQ(stream->warning(),
            "controls were not set: zoom_absolute: the device has no such control");
  EXPECT_EQ(machine_->valueOf("video0", V4L2_CID_GAIN), 64);
}

TEST_F(DeviceStreamTest, DoesNotTakeADeviceThatGotTheNumberMeanwhile) {
  bool isCalm = false;
  const auto left = eventfulStream([&] {
    if (!isCalm) { // the twins come back with each other's numbers
      machine_->unplug("video0");
      machine_->unplug("video2");
      plugAs("video0", "4");
      plugAs("video2", "3");
    }
  });
  const auto opened = left->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error(), "another device took its place while it was opened");
  EXPECT_EQ(left->lostReason(), "");
  EXPECT_EQ(machine_->valueOf("video0", V4L2_CID_GAIN), 64); // the other camera is left alone
  isCalm = true;
  EXPECT_TRUE(left->open());
  EXPECT_EQ(machine_->valueOf("video2", V4L2_CID_GAIN), 7);
}

TEST_F(DeviceStreamTest, OpensADeviceThatCannotBeOpenedTwice) {
  EXPECT_TRUE(eventfulStream([&] { machine_->setOpenError("video0", EBUSY); })->open());
  machine_->setOpenError("video0", 0);
  // It is unplugged at once: reading will tell.
  EXPECT_TRUE(eventfulStream([&] { machine_->unplug("video0"); })->open());
}

TEST_F(DeviceStreamTest, KnowsWhenTheDataOfAnImageArrived) {
  const auto left = eventfulStream([] {});
  ASSERT_TRUE(left->open());
  ASSERT_TRUE(left->grab());
  EXPECT_EQ(left->arrivalTime(), EventfulStream::kArrival);
}

TEST_F(DeviceStreamTest, LeavesALocationWithoutIdentity) {
  identities_[0] = {};
  ASSERT_TRUE(streamOf(0, {"MJPG", 0, 0, 0.0}, {{"gain", 7}})->open());
  EXPECT_EQ(*opened_, "/dev/video0");
  EXPECT_EQ(machine_->valueOf("video0", V4L2_CID_GAIN), 7);
  EXPECT_FALSE(streamOf(0, {"H264", 0, 0, 0.0})->open());
  LiveCamera numbered;
  numbered.location = "2";
  numbered.device.controls = {{"gain", 9}};
  const auto stream =
      makeDeviceStream(numbered, {access_, {DeviceIdentity{}}, 0}, [this](const LiveCamera& found) {
        return std::make_unique<RememberedStream>(found.location, opened_);
      });
  ASSERT_TRUE(stream->open());
  EXPECT_EQ(stream->warning(), "");
  EXPECT_EQ(machine_->valueOf("video2", V4L2_CID_GAIN), 9);
}

TEST_F(DeviceStreamTest, LiveCamerasNameTheMissingDevice) {
  machine_->unplug("video0");
  // Both cameras of the project: the other device, of the same model, is taken.
  std::vector<LiveCamera> cameras(2);
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    cameras[k].name = k == 0 ? "left" : "right";
    cameras[k].location = k == 0 ? "/dev/video0" : "/dev/video2";
    cameras[k].device.identity = identities_[k];
  }
  const auto source = openLive(cameras, std::vector<EncodedFeedPtr>(2), access_);
  ASSERT_TRUE(source) << errorSentence(source.error());
  const auto isOfLeft = [](const Error& one) { return one.field == "camera 'left'"; };
  std::vector<Error> notices;
  for (int attempt = 0; attempt < 1000 && std::ranges::none_of(notices, isOfLeft); ++attempt) {
    ASSERT_TRUE((*source)->next());
    notices = (*source)->notices();
  }
  const auto found = std::ranges::find_if(notices, isOfLeft);
  ASSERT_NE(found, notices.end());
  EXPECT_EQ(found->code, ErrorCode::DeviceUnavailable);
  EXPECT_NE(found->detail.find("'HD Webcam'"), std::string::npos) << found->detail;
}

} // namespace
} // namespace dewpoint::tests
