// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/live_frame_source.h"
#include "core/capture/live_stream.h"
#include "tests/capture/mjpeg_server.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using test::MjpegServer;

/// Calls to next() until something surely happened: each takes the time between two frames, 5 ms or
/// more, and at most about 0.1 s.
constexpr int kManyTries = 3000;

/// A white square that moves to the right by four pixels per picture. The background changes too,
/// so that a picture is not sent twice within a second.
cv::Mat movingSquare(std::int64_t number) {
  cv::Mat picture(48, 64, CV_8UC3, cv::Scalar::all(30.0 + static_cast<double>(number % 61)));
  const int x = static_cast<int>(number * 4 % 48);
  cv::rectangle(picture, cv::Rect(x, 16, 16, 16), cv::Scalar::all(250), cv::FILLED);
  return picture;
}

double squareCenter(const cv::Mat& picture) {
  cv::Mat mask;
  cv::inRange(picture, cv::Scalar::all(128), cv::Scalar::all(255), mask);
  const cv::Moments moments = cv::moments(mask, true);
  return moments.m00 > 0 ? moments.m10 / moments.m00 : -1;
}

LiveCamera camera(const std::string& location, const std::string& name = "left") {
  LiveCamera result;
  result.name = name;
  result.location = location;
  return result;
}

/// The first frame set that fits, or null after many tries.
template <class Fits> FrameSetPtr waitFor(FrameSetSource& source, Fits fits) {
  for (int attempt = 0; attempt < kManyTries; ++attempt) {
    const auto set = source.next();
    if (!set) {
      return nullptr;
    }
    if (fits(**set)) {
      return *set;
    }
  }
  return nullptr;
}

bool complete(const FrameSet& set) {
  return std::ranges::all_of(set.frames, [](const auto& frame) { return frame != nullptr; });
}

bool blank(const FrameSet& set) {
  return std::ranges::none_of(set.frames, [](const auto& frame) { return frame != nullptr; });
}

/// A camera under the test's control, in this process.
struct FakeDevice {
  std::atomic<bool> present{true};
  std::atomic<bool> hangs{false};
  std::atomic<int> width{64};
  std::atomic<int> opened{0};
  std::atomic<int> sent{0};
  std::atomic<bool> frozen{false}; ///< sends the same picture all the time
  std::string warning = {};        ///< does not change
};

class FakeStream final : public LiveStream {
public:
  explicit FakeStream(std::shared_ptr<FakeDevice> device) : device_(std::move(device)) {}
  tl::expected<void, std::string> open() override {
    if (!device_->present) {
      return tl::make_unexpected(std::string("unplugged"));
    }
    ++device_->opened;
    return {};
  }
  bool grab() override {
    std::this_thread::sleep_for(5ms);
    while (device_->hangs) {
      std::this_thread::sleep_for(5ms);
    }
    return device_->present;
  }
  cv::Mat retrieve() override {
    const int number = device_->frozen ? 0 : ++device_->sent;
    return {48, device_->width, CV_8UC3,
            cv::Scalar(60 + number % 150, 60 + number / 150 % 150, 90)};
  }
  std::string warning() const override { return device_->warning; }

private:
  std::shared_ptr<FakeDevice> device_;
};

LiveStreamFactory makes(std::vector<std::shared_ptr<FakeDevice>> devices) {
  return [devices = std::move(devices)](const LiveCamera& description) -> LiveStreamPtr {
    return std::make_unique<FakeStream>(devices.at(std::stoul(description.location)));
  };
}

TEST(LiveFrameSource, AnImageKnowsWhenItPassedTheStages) {
  const auto device = std::make_shared<FakeDevice>();
  LiveCamera late = camera("0");
  late.delaySeconds = 0.05;
  const auto before = std::chrono::steady_clock::now();
  const auto source = openLive({late}, makes({device}));
  ASSERT_TRUE(source) << errorSentence(source.error());
  const FrameSetPtr set = waitFor(**source, complete);
  ASSERT_TRUE(set);
  const LiveInstants& passed = set->frames[0]->instants;
  EXPECT_GT(passed.arrivedAt, before);
  EXPECT_EQ(passed.capturedAt, passed.arrivedAt - 50ms); // its light is that much older
  EXPECT_GE(passed.decodedAt, passed.arrivedAt);
  EXPECT_LE(passed.decodedAt, std::chrono::steady_clock::now());
}

/// A camera whose images are on their way for 0.3 s, and which reports when they were captured.
class SlowStream final : public LiveStream {
public:
  explicit SlowStream(std::shared_ptr<FakeDevice> device) : stream_(std::move(device)) {}
  tl::expected<void, std::string> open() override { return stream_.open(); }
  bool grab() override {
    const bool grabbed = stream_.grab();
    captured_ = {std::chrono::steady_clock::now() - 300ms, TimeOrigin::Driver};
    return grabbed;
  }
  cv::Mat retrieve() override { return stream_.retrieve(); }
  std::optional<CaptureInstant> captureTime() const override { return captured_; }

private:
  FakeStream stream_;
  CaptureInstant captured_;
};

TEST(LiveFrameSource, ASetWithoutImagesIsNotAheadOfTheNextImage) {
  const auto device = std::make_shared<FakeDevice>();
  const auto source = openLive(
      {camera("0")}, [&](const LiveCamera&) { return std::make_unique<SlowStream>(device); });
  ASSERT_TRUE(source);
  // No set is before the start, which the first images are.
  ASSERT_TRUE(waitFor(**source, [](const FrameSet& set) {
    return complete(set) && set.frames[0]->captureTime > TimeStamp{};
  }));
  device->hangs = true;
  ASSERT_TRUE(waitFor(**source, blank));
  device->hangs = false;
  const FrameSetPtr set = waitFor(**source, complete);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->time, set->frames[0]->captureTime);
}

TEST(LiveFrameSource, reportsWhatIsWrongWithACameraThatDelivers) {
  const auto device = std::make_shared<FakeDevice>();
  device->warning = "controls were not set: gain";
  const auto opened = openLive({camera("0")}, makes({device}));
  ASSERT_TRUE(opened);
  FrameSetSource& source = **opened;
  ASSERT_TRUE(waitFor(source, complete));
  const auto notices = source.notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].field, "camera 'left'");
  EXPECT_EQ(notices[0].detail, "controls were not set: gain");
  device->present = false; // another problem, which hides it
  ASSERT_TRUE(waitFor(source, [&](const FrameSet&) {
    const auto now = source.notices();
    return now.size() == 1 && now[0].code == ErrorCode::ConnectionLost;
  }));
}

TEST(LiveFrameSource, reportsAFrozenCameraUntilItGoesOn) {
  const auto device = std::make_shared<FakeDevice>();
  device->frozen = true;
  const auto source = openLive({camera("0")}, makes({device}));
  ASSERT_TRUE(source);
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet&) { return !(*source)->notices().empty(); }));
  const auto notices = (*source)->notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].code, ErrorCode::ImagesFrozen);
  EXPECT_EQ(notices[0].field, "camera 'left'");
  EXPECT_TRUE(waitFor(**source, complete)); // the images are used all the same
  device->frozen = false;
  EXPECT_TRUE(waitFor(**source, [&](const FrameSet&) { return (*source)->notices().empty(); }));
}

TEST(LiveFrameSource, aSilentCameraIsLost) {
  const auto device = std::make_shared<FakeDevice>();
  const auto source = openLive({camera("0")}, makes({device}));
  ASSERT_TRUE(source);
  int images = 0;
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet& set) { // until its rate is known
    images += complete(set) ? 1 : 0;
    return images > 10;
  }));
  device->hangs = true;
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet&) { return !(*source)->notices().empty(); }));
  EXPECT_EQ((*source)->notices()[0].code, ErrorCode::ConnectionLost);
  device->hangs = false;
}

TEST(LiveFrameSource, deliversAMovingPictureFromTheNetwork) {
  const MjpegServer left(movingSquare);
  const MjpegServer right(movingSquare);
  const auto source = openLive({camera(left.address()), camera(right.address(), "right")});
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_TRUE((*source)->isLive());
  ASSERT_TRUE(waitFor(**source, complete));
  std::vector<TimeStamp> last(2, TimeStamp{-1});
  std::vector<std::int64_t> lastIndex(2, -1);
  TimeStamp lastTime{-1};
  std::int64_t lastSet = -1;
  std::set<int> places;
  for (int k = 0; k < 20; ++k) {
    const FrameSetPtr set = (*source)->next().value();
    ASSERT_EQ(set->frames.size(), 2U);
    EXPECT_GT(set->index, lastSet);
    lastSet = set->index;
    EXPECT_GE(set->time, lastTime);
    lastTime = set->time;
    for (std::size_t c = 0; c < 2; ++c) {
      const FramePtr& frame = set->frames[c];
      if (!frame) {
        continue;
      }
      EXPECT_GT(frame->captureTime, last[c]);
      EXPECT_GT(frame->index, lastIndex[c]);
      last[c] = frame->captureTime;
      lastIndex[c] = frame->index;
      ASSERT_EQ(frame->image.size(), cv::Size(64, 48));
      ASSERT_EQ(frame->image.type(), CV_8UC3);
      places.insert(static_cast<int>(squareCenter(frame->image)));
    }
  }
  EXPECT_GT(places.size(), 3U); // the picture moves
  EXPECT_TRUE((*source)->notices().empty());
  EXPECT_GT((*source)->framesPerSecond(), 0);
}

TEST(LiveFrameSource, aServerThatDiesIsNoticedAndComesBack) {
  auto server = std::make_unique<MjpegServer>(movingSquare);
  const auto port = server->port();
  const auto source = openLive({camera(server->address())});
  ASSERT_TRUE(source);
  ASSERT_TRUE(waitFor(**source, complete));
  server.reset();
  ASSERT_TRUE(waitFor(
      **source, [&](const FrameSet& set) { return blank(set) && !(*source)->notices().empty(); }));
  const auto notices = (*source)->notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].code, ErrorCode::ConnectionLost);
  EXPECT_EQ(notices[0].field, "camera 'left'");
  EXPECT_TRUE(blank(*(*source)->next().value()));
  server = std::make_unique<MjpegServer>(movingSquare, port);
  EXPECT_TRUE(waitFor(**source, complete));
  EXPECT_TRUE((*source)->notices().empty());
}

TEST(LiveFrameSource, aCameraThatIsNotThereLeavesTheOthersAlone) {
  auto present = std::make_shared<FakeDevice>();
  auto absent = std::make_shared<FakeDevice>();
  absent->present = false;
  const auto source = openLive({camera("0"), camera("1", "right")}, makes({present, absent}));
  ASSERT_TRUE(source);
  const auto onlyLeft = [](const FrameSet& set) { return set.frames[0] && !set.frames[1]; };
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet& set) {
    return onlyLeft(set) && !(*source)->notices().empty();
  }));
  const auto notices = (*source)->notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].code, ErrorCode::DeviceUnavailable);
  EXPECT_EQ(notices[0].field, "camera 'right'");
  absent->present = true; // plugged in
  EXPECT_TRUE(waitFor(**source, complete));
  EXPECT_TRUE((*source)->notices().empty());
  absent->hangs = true; // its last frame may still come, then the left camera goes on alone
  EXPECT_TRUE(waitFor(**source, onlyLeft));
  EXPECT_TRUE(waitFor(**source, [&](const FrameSet&) {
    const auto now = (*source)->notices();
    return now.size() == 1 && now[0].code == ErrorCode::ConnectionLost;
  }));
  absent->hangs = false;
  EXPECT_TRUE(waitFor(**source, complete));
  EXPECT_TRUE((*source)->notices().empty());
}

TEST(LiveFrameSource, aWrongSizeIsNoticedAndNotPassedOn) {
  auto device = std::make_shared<FakeDevice>();
  device->width = 32;
  LiveCamera rotated = camera("0");
  rotated.rotateDegrees = 90;
  rotated.width = 48; // the fake's 64 x 48, turned
  rotated.height = 64;
  const auto source = openLive({rotated}, makes({device}));
  ASSERT_TRUE(source);
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet& set) {
    EXPECT_TRUE(blank(set));
    return !(*source)->notices().empty();
  }));
  EXPECT_EQ((*source)->notices()[0].code, ErrorCode::Mismatch);
  EXPECT_EQ((*source)->notices()[0].detail, "48 x 32, but its calibration is for 48 x 64");
  device->width = 64;
  const auto set = waitFor(**source, complete);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->frames[0]->image.size(), cv::Size(48, 64));
  EXPECT_TRUE((*source)->notices().empty());
}

TEST(LiveFrameSource, countsFramesNobodyLookedAt) {
  auto device = std::make_shared<FakeDevice>();
  const auto source = openLive({camera("0")}, makes({device}));
  ASSERT_TRUE(source);
  const auto first = waitFor(**source, complete);
  ASSERT_TRUE(first);
  while ((*source)->droppedFrameCount() < 5) {
    std::this_thread::sleep_for(1ms);
  }
  const auto second = waitFor(**source, complete);
  ASSERT_TRUE(second);
  EXPECT_GE(second->frames[0]->index, first->frames[0]->index + 6); // five dropped between
}

TEST(LiveFrameSource, aReadThatHangsDoesNotBlockTheEnd) {
  auto device = std::make_shared<FakeDevice>();
  auto opened = openLive({camera("0")}, makes({device}));
  ASSERT_TRUE(opened);
  std::unique_ptr<FrameSetSource> source = std::move(*opened);
  ASSERT_TRUE(waitFor(*source, complete));
  device->hangs = true;
  ASSERT_TRUE(waitFor(*source, blank));
  source.reset(); // returns although grab() does not: else the test's time limit strikes
  EXPECT_TRUE(device->hangs);
  device->hangs = false;
  // The abandoned thread lets go of its connection as soon as its read returns.
  while (device.use_count() > 1) {
    std::this_thread::sleep_for(1ms);
  }
}

TEST(LiveFrameSource, settingsThatCannotWorkAreRefused) {
  for (const char* location : {"", "gst:", "video.mp4", "/dev/videoX", "-1", "ftp://host/a"}) {
    const auto source = openLive({camera(location)});
    ASSERT_FALSE(source) << location;
    EXPECT_EQ(source.error().code, ErrorCode::BadValue);
  }
  for (const char* location :
       {"0", "/dev/video2", "rtsp://host/a", "gst:videotestsrc ! appsink", "test:ball",
        "/dev/v4l/by-id/usb-camera-video-index0", "srt://host:9"}) {
    EXPECT_TRUE(checkLocation(camera(location))) << location;
  }
  LiveCamera tilted = camera("0");
  tilted.rotateDegrees = 30;
  EXPECT_EQ(openLive({tilted}).error().code, ErrorCode::BadValue);
  EXPECT_EQ(openLive({}).error().code, ErrorCode::MissingKey);
}

TEST(LiveFrameSource, aMissingDeviceIsANotice) {
  const auto source = openLive({camera("/dev/video987")}); // no machine has so many
  ASSERT_TRUE(source);
  ASSERT_TRUE(waitFor(**source, [&](const FrameSet&) { return !(*source)->notices().empty(); }));
  EXPECT_EQ((*source)->notices()[0].code, ErrorCode::DeviceUnavailable);
}

} // namespace
} // namespace dewpoint::tests
