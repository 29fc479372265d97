// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/encoded_feed.h"
#include "core/capture/gstreamer/gst_library.h"
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/gstreamer/stream_recording.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include <gst/gst.h>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using PreRollClock = EncodedFeed::Clock;

constexpr std::size_t kImageBytes = 1000;
constexpr auto kImageInterval = 100ms;

/// Image number k of a stream with a key frame every `keyInterval` images.
EncodedImage imageNumber(int k, int keyInterval = 1, int width = 320) {
  GstBuffer* buffer = gst_buffer_new_allocate(nullptr, kImageBytes, nullptr);
  if (k % keyInterval != 0) {
    GST_BUFFER_FLAG_SET(buffer, GST_BUFFER_FLAG_DELTA_UNIT);
  }
  GstCaps* caps = gst_caps_new_simple("video/x-h264", "width", G_TYPE_INT, width, "height",
                                      G_TYPE_INT, 240, nullptr);
  const std::shared_ptr<GstSample> sample(gst_sample_new(buffer, caps, nullptr, nullptr),
                                          gst_sample_unref);
  gst_caps_unref(caps);
  gst_buffer_unref(buffer);
  return {sample, {PreRollClock::time_point(k * kImageInterval), TimeOrigin::Driver}};
}

int numberOf(const EncodedImage& image) {
  return static_cast<int>(image.captureInstant.time.time_since_epoch() / kImageInterval);
}

class PreRollTest : public testing::Test {
protected:
  PreRollTest() { startGStreamer(); }
};

TEST_F(PreRollTest, KeepsTheLastSeconds) {
  PreRoll preRoll({1s, 1 << 20});
  for (int k = 0; k < 100; ++k) {
    preRoll.add(imageNumber(k));
  }
  EXPECT_EQ(numberOf(preRoll.images().front()), 89); // 1 s before the newest
  EXPECT_EQ(numberOf(preRoll.images().back()), 99);
  EXPECT_EQ(preRoll.status().imageCount, 11U);
  EXPECT_DOUBLE_EQ(preRoll.status().spanSeconds, 1.0);
  EXPECT_FALSE(preRoll.status().isShortened);
}

TEST_F(PreRollTest, BeginsWithAKeyFrame) {
  PreRoll preRoll({1s, 1 << 20});
  preRoll.add(imageNumber(3, 8)); // needs an image that nobody has
  EXPECT_TRUE(preRoll.images().empty());
  for (int k = 8; k < 100; ++k) {
    preRoll.add(imageNumber(k, 8));
    EXPECT_EQ(numberOf(preRoll.images().front()) % 8, 0);
  }
  EXPECT_EQ(numberOf(preRoll.images().front()), 88); // the last one at or before 8.9 s
}

TEST_F(PreRollTest, MemoryIsLimitedAndThatIsReported) {
  PreRoll preRoll({10s, 30 * kImageBytes});
  for (int k = 0; k < 64; ++k) {
    preRoll.add(imageNumber(k, 8));
    EXPECT_LE(preRoll.status().byteCount, 30 * kImageBytes);
  }
  EXPECT_TRUE(preRoll.status().isShortened);
  EXPECT_EQ(numberOf(preRoll.images().front()) % 8, 0);
  EXPECT_EQ(preRoll.status().byteCount, preRoll.images().size() * kImageBytes);
  PreRoll tiny({10s, 3 * kImageBytes}); // not even one group fits
  for (int k = 0; k < 64; ++k) {
    tiny.add(imageNumber(k, 8));
    EXPECT_LE(tiny.images().size(), 3U);
  }
}

TEST_F(PreRollTest, ImagesOfAnotherFormatAreAnotherBeginning) {
  PreRoll preRoll({10s, 1 << 20});
  preRoll.add(imageNumber(0));
  preRoll.add(imageNumber(1, 1, 640));
  preRoll.add(imageNumber(2, 1, 640));
  EXPECT_EQ(numberOf(preRoll.images().front()), 1);
}

TEST_F(PreRollTest, AReceiverGetsWhatWasKeptFirst) {
  EncodedFeed feed;
  feed.put(imageNumber(0)); // nothing is kept before it is requested
  feed.setPreRoll({10s, 1 << 20});
  for (int k = 1; k < 5; ++k) {
    feed.put(imageNumber(k));
  }
  EXPECT_EQ(feed.preRollBegin(), PreRollClock::time_point(kImageInterval));
  std::vector<int> received;
  feed.connect([&](const EncodedImage& image) { received.push_back(numberOf(image)); });
  feed.put(imageNumber(5));
  EXPECT_EQ(received, (std::vector{1, 2, 3, 4, 5}));
  feed.disconnect();
  EXPECT_FALSE(feed.preRollBegin()); // what was recorded is not kept again
  feed.put(imageNumber(6));
  EXPECT_TRUE(feed.preRollBegin());
  feed.markEnded();
  EXPECT_FALSE(feed.preRollBegin());
  feed.put(imageNumber(7));
  feed.setPreRoll({});
  EXPECT_FALSE(feed.preRollBegin());
}

TEST_F(PreRollTest, IsWrittenBeforeTheRestWithItsTimes) {
  for (const char* encoding : {"raw", "mjpeg", "h264"}) {
    const test::TemporaryFolder folder;
    LiveCamera camera;
    camera.location = std::string("test:ball?width=320&height=240&rate=30&encoding=") + encoding;
    const auto feed = std::make_shared<EncodedFeed>();
    feed->setPreRoll({2s, std::size_t{256} << 20});
    const LiveStreamPtr stream = makeLiveStream(camera, feed);
    ASSERT_TRUE(stream->open());
    std::jthread reader([&](const std::stop_token& stop) {
      while (!stop.stop_requested() && stream->grab()) {
        (void)stream->retrieve();
      }
    });
    const auto deadline = PreRollClock::now() + 20s;
    while (feed->preRoll().imageCount < 45 && PreRollClock::now() < deadline) {
      std::this_thread::sleep_for(10ms);
    }
    const auto zero = feed->preRollBegin();
    ASSERT_TRUE(zero) << encoding;
    StreamRecording recording(feed, {folder / "left.mkv", folder / "left.csv"}, RawStorage::Jpeg,
                              *zero, "", PreRollClock::now());
    while (recording.counts().imageCount < 75 && PreRollClock::now() < deadline) {
      std::this_thread::sleep_for(10ms);
    }
    recording.stop();
    const RecordedCounts counts = recording.counts();
    EXPECT_FALSE(counts.problem);
    EXPECT_GE(counts.preRollImageCount, 40) << encoding;
    EXPECT_GE(counts.imageCount, 75) << encoding;
    EXPECT_EQ(counts.droppedImageCount, 0) << encoding;
    EXPECT_NEAR(counts.framesPerSecond, 30.0, 0.3) << encoding; // no hole at the start
    cv::VideoCapture video(folder / "left.mkv", cv::CAP_FFMPEG);
    std::int64_t images = 0;
    while (video.grab()) {
      ++images;
    }
    EXPECT_EQ(images, counts.imageCount) << encoding;
  }
}

} // namespace
} // namespace dewpoint::tests
