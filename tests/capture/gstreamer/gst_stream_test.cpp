// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/gst_image.h"
#include "core/capture/gstreamer/gst_stream.h"
#include "core/capture/gstreamer/open_live.h"
#include "tests/capture/mjpeg_server.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gst/app/gstappsrc.h>
#include <gst/gst.h>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

LiveCamera located(const std::string& location) {
  LiveCamera camera;
  camera.name = "left";
  camera.location = location;
  return camera;
}

struct SeenImage {
  cv::Mat image;
  CaptureInstant captured;
};

/// Some images of an opened stream; fewer if it is lost or takes longer than 20 s.
std::vector<SeenImage> imagesOf(LiveStream& stream, std::size_t count) {
  std::vector<SeenImage> seen;
  const auto deadline = Steady::now() + 20s;
  while (seen.size() < count && Steady::now() < deadline && stream.grab()) {
    if (cv::Mat image = stream.retrieve(); !image.empty()) {
      seen.push_back({image, stream.captureTime().value_or(CaptureInstant{})});
    }
  }
  return seen;
}

double interval(const SeenImage& first, const SeenImage& second) {
  return std::chrono::duration<double>(second.captured.time - first.captured.time).count();
}

TEST(GstStream, ShowsTestPatternsInAnyEncoding) {
  for (const char* encoding : {"raw", "mjpeg", "h264"}) {
    const auto feed = std::make_shared<EncodedFeed>();
    std::string mediaType;
    feed->connect([&](const EncodedImage& image) { mediaType = mediaTypeOf(*image.sample); });
    const auto stream = makeLiveStream(
        located(std::string("test:ball?width=320&height=240&rate=25&encoding=") + encoding), feed);
    const auto opened = stream->open();
    ASSERT_TRUE(opened) << opened.error();
    const auto seen = imagesOf(*stream, 20);
    ASSERT_EQ(seen.size(), 20U) << encoding;
    for (const SeenImage& one : seen) {
      ASSERT_EQ(one.image.size(), cv::Size(320, 240));
      ASSERT_EQ(one.image.type(), CV_8UC3);
      EXPECT_EQ(one.captured.origin, TimeOrigin::Driver);
      EXPECT_LT(one.captured.time, Steady::now());
      EXPECT_GT(one.captured.time, Steady::now() - 10s);
    }
    // Capture times are those of the source, however late the images are here.
    for (std::size_t k = 1; k < seen.size(); ++k) {
      const double frames = interval(seen[k - 1], seen[k]) * 25.0;
      EXPECT_NEAR(frames, std::round(frames), 1e-3) << encoding;
      EXPECT_GT(frames, 0.5);
    }
    // The feed gets its images in a thread of its own, which may be later.
    for (int k = 0; k < 500 && feed->imageCount() < 20; ++k) {
      std::this_thread::sleep_for(10ms);
    }
    feed->disconnect();
    EXPECT_GE(feed->imageCount(), 20);
    EXPECT_EQ(mediaType, std::string(encoding) == "raw"     ? "video/x-raw"
                         : std::string(encoding) == "mjpeg" ? "image/jpeg"
                                                            : "video/x-h264");
  }
}

TEST(GstStream, ReadsMultipartJpegUnchanged) {
  const auto color = [](std::int64_t) {
    return cv::Mat(48, 64, CV_8UC3, cv::Scalar(40, 120, 200));
  };
  const test::MjpegServer server(color);
  const auto feed = std::make_shared<EncodedFeed>();
  std::vector<unsigned char> bytes;
  feed->connect([&](const EncodedImage& image) {
    GstBuffer* buffer = gst_sample_get_buffer(image.sample.get());
    bytes.resize(gst_buffer_get_size(buffer));
    gst_buffer_extract(buffer, 0, bytes.data(), bytes.size());
  });
  const auto stream = makeLiveStream(located(server.address()), feed);
  ASSERT_TRUE(stream->open());
  const auto seen = imagesOf(*stream, 5);
  feed->disconnect();
  ASSERT_EQ(seen.size(), 5U);
  const cv::Scalar mean = cv::mean(seen.back().image);
  EXPECT_NEAR(mean[0], 40, 3);
  EXPECT_NEAR(mean[1], 120, 3);
  EXPECT_NEAR(mean[2], 200, 3);
  std::vector<unsigned char> sent;
  cv::imencode(".jpg", color(0), sent);
  EXPECT_EQ(bytes, sent);
}

TEST(GstStream, DataArriveBeforeTheyAreDecoded) {
  for (const char* encoding : {"raw", "mjpeg", "h264"}) {
    const auto stream = makeLiveStream(
        located(std::string("test:ball?width=320&height=240&encoding=") + encoding), nullptr);
    ASSERT_TRUE(stream->open()) << encoding;
    for (int k = 0; k < 5; ++k) {
      ASSERT_TRUE(stream->grab()) << encoding;
      const auto grabbed = Steady::now();
      if (stream->retrieve().empty()) {
        continue;
      }
      const auto arrived = stream->arrivalTime();
      const auto captured = stream->captureTime();
      ASSERT_TRUE(arrived && captured) << encoding;
      EXPECT_LE(*arrived, grabbed) << encoding;
      EXPECT_GT(*arrived, grabbed - 5s) << encoding;
    }
  }
}

TEST(GstStream, AServerThatStopsIsLostWithAReason) {
  auto server = std::make_unique<test::MjpegServer>(
      [](std::int64_t) { return cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(9)); });
  const auto stream = makeLiveStream(located(server->address()), nullptr);
  ASSERT_TRUE(stream->open());
  ASSERT_EQ(imagesOf(*stream, 2).size(), 2U);
  server.reset();
  const auto begin = Steady::now();
  while (stream->grab() && Steady::now() - begin < 20s) {
  }
  EXPECT_LT(Steady::now() - begin, 5s);
  EXPECT_FALSE(stream->lostReason().empty());
  EXPECT_FALSE(stream->hasEnded()); // it may come back
}

/// JPEG over RTP, sent to a port of this computer.
class RtpSender {
public:
  explicit RtpSender(int port) {
    std::string reason;
    pipeline_ =
        makePipeline("videotestsrc is-live=true ! video/x-raw,format=I420,width=320,height=240,"
                     "framerate=30/1 ! jpegenc ! rtpjpegpay ! udpsink host=127.0.0.1 port=" +
                         std::to_string(port),
                     reason);
    EXPECT_TRUE(pipeline_) << reason;
    gst_element_set_state(pipeline_.get(), GST_STATE_PLAYING);
  }
  void pause() { gst_element_set_state(pipeline_.get(), GST_STATE_PAUSED); }

private:
  GstElementPtr pipeline_;
};

TEST(GstStream, TimesOfRtpAreThoseOfTheSender) {
  constexpr int kPort = 15672;
  RtpSender sender(kPort);
  const auto stream = makeLiveStream(
      located("rtp://127.0.0.1:" + std::to_string(kPort) + "?encoding=JPEG"), nullptr);
  ASSERT_TRUE(stream->open());
  const auto seen = imagesOf(*stream, 30);
  ASSERT_EQ(seen.size(), 30U);
  EXPECT_EQ(seen.back().captured.origin, TimeOrigin::Sender);
  // The sender's clock, not the moments at which a busy computer gets the packets.
  // At first they move together by the delay of the fastest packet so far.
  EXPECT_GE(30.0 * interval(seen[9], seen[29]), 15.0);
  for (std::size_t k = 1; k < seen.size(); ++k) {
    EXPECT_GT(seen[k].captured.time, seen[k - 1].captured.time);
  }
  // A silent sender: neither call blocks for more than about 2 s.
  sender.pause();
  bool alive = true;
  const auto silent = Steady::now();
  while (alive && Steady::now() - silent < 20s) {
    const auto begin = Steady::now();
    alive = stream->grab();
    EXPECT_LT(Steady::now() - begin, 3s);
  }
  EXPECT_FALSE(alive);
  EXPECT_EQ(stream->lostReason(), "no data for two seconds");
}

TEST(GstStream, FailsInTimeAndSaysWhy) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"/dev/video987", "no such device is plugged in"},
      {"udp://127.0.0.1:15999", "no answer for two seconds"},
      {"rtsp://anna:s3cret@127.0.0.1:9/a", "nothing answers"},
      {"http://anna:s3cret@127.0.0.1:9/a", "no video stream"},
      {"gst:no_such_element ! appsink", "no_such_element"},
      {"gst:videotestsrc ! fakesink", "cannot be made"},
      {"gst:videotestsrc ! jpegenc ! appsink", ""},
  };
  for (const auto& [location, reason] : wrong) {
    const auto begin = Steady::now();
    const auto stream = makeLiveStream(located(location), nullptr);
    const auto opened = stream->open();
    EXPECT_LT(Steady::now() - begin, 4s) << location;
    if (reason.empty()) {
      ASSERT_TRUE(opened);
      EXPECT_FALSE(stream->grab());
      EXPECT_NE(stream->lostReason().find("put a decoder before it"), std::string::npos);
      continue;
    }
    ASSERT_FALSE(opened) << location;
    EXPECT_NE(opened.error().find(reason), std::string::npos) << location << ": " << opened.error();
    EXPECT_EQ(opened.error().find("s3cret"), std::string::npos);
  }
}

TEST(GstStream, AFiniteSourceEnds) {
  const auto feed = std::make_shared<EncodedFeed>();
  const auto stream = makeLiveStream(located("test:ball?rate=60&frames=12"), feed);
  ASSERT_TRUE(stream->open());
  EXPECT_LE(imagesOf(*stream, 100).size(), 12U); // a busy computer shows fewer, ...
  EXPECT_EQ(feed->imageCount(), 12);             // ... but none is missing for a recording
  EXPECT_TRUE(stream->hasEnded());
  EXPECT_EQ(stream->lostReason(), "the stream has ended");
  EXPECT_TRUE(feed->endTime());
}

TEST(GstStream, EndsAfterTheLastImageForARecording) {
  const auto feed = std::make_shared<EncodedFeed>();
  feed->connect([](const EncodedImage&) { std::this_thread::sleep_for(40ms); });
  const auto stream = makeLiveStream(located("test:ball?rate=60&frames=12"), feed);
  ASSERT_TRUE(stream->open());
  imagesOf(*stream, 100); // their branch ends 0.2 s after the start, the other 0.5 s
  EXPECT_EQ(feed->imageCount(), 12);
  EXPECT_TRUE(feed->endTime());
}

TEST(GstStream, AcceptsPipelinesWithAndWithoutASink) {
  for (const char* rest :
       {" ! appsink", " ! videoconvert ! video/x-raw,format=BGR ! appsink", "", " ! jpegenc"}) {
    const auto stream =
        makeLiveStream(located("gst:videotestsrc is-live=true pattern=red ! "
                               "video/x-raw,format=YUY2,width=64,height=48,framerate=30/1" +
                               std::string(rest)),
                       nullptr);
    const auto opened = stream->open();
    ASSERT_TRUE(opened) << rest << ": " << opened.error();
    const auto seen = imagesOf(*stream, 3);
    ASSERT_EQ(seen.size(), 3U) << rest;
    const cv::Scalar mean = cv::mean(seen.back().image);
    EXPECT_GT(mean[2], 220) << rest; // a JPEG of this encoder has another range of colors
    EXPECT_LT(mean[0], 30) << rest;
  }
}

/// Pushes images with the time stamps that `stampOf` makes of the running time, until its end.
class PlantedSource {
public:
  using StampOf = std::function<GstClockTime(GstClockTime)>;

  PlantedSource(GstElement* pipeline, StampOf stampOf) {
    thread_ = std::jthread([pipeline, stampOf](const std::stop_token& stop) {
      GstElement* source = gst_bin_get_by_name(GST_BIN(pipeline), "planted");
      while (!stop.stop_requested()) {
        std::this_thread::sleep_for(10ms);
        GstBuffer* buffer = gst_buffer_new_allocate(nullptr, 64 * 48 * 3, nullptr);
        const GstClockTime now = gst_element_get_current_running_time(source);
        GST_BUFFER_PTS(buffer) = GST_CLOCK_TIME_IS_VALID(now) ? stampOf(now) : GST_CLOCK_TIME_NONE;
        gst_app_src_push_buffer(GST_APP_SRC(source), buffer);
      }
      gst_object_unref(source);
    });
  }

private:
  std::jthread thread_;
};

TEST(GstStream, BadTimeStampsGiveTheTimeOfArrival) {
  const std::vector<std::pair<PlantedSource::StampOf, TimeOrigin>> plants{
      {[](GstClockTime now) { return now; }, TimeOrigin::Driver},
      {[](GstClockTime) { return GST_CLOCK_TIME_NONE; }, TimeOrigin::Arrival},
      {[](GstClockTime now) { return now + 60 * GST_SECOND; }, TimeOrigin::Arrival},
      {[](GstClockTime) { return GstClockTime{0}; }, TimeOrigin::Arrival}}; // always the same
  for (const auto& [stampOf, origin] : plants) {
    GstStream stream(*pipelineText(located(
                         "gst:appsrc name=planted format=time is-live=true caps=video/x-raw,"
                         "format=BGR,width=64,height=48,framerate=100/1 ! appsink sync=false")),
                     nullptr);
    ASSERT_TRUE(stream.createPipeline());
    const PlantedSource source(stream.pipeline(), stampOf);
    ASSERT_TRUE(stream.open());
    const auto seen = imagesOf(stream, 20);
    ASSERT_EQ(seen.size(), 20U);
    for (std::size_t k = 1; k < seen.size(); ++k) {
      EXPECT_EQ(seen[k].captured.origin, origin) << k;
      EXPECT_GT(seen[k].captured.time, seen[k - 1].captured.time);
      EXPECT_LE(seen[k].captured.time, Steady::now());
      EXPECT_GT(seen[k].captured.time, Steady::now() - 5s);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
