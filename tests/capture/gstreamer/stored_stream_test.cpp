// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/gstreamer/stored_stream.h"
#include "core/capture/gstreamer/stream_recording.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <map>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using StoredClock = StreamRecording::Clock;

/// Records a live camera, and compares the images that were seen live with those in the video.
void expectSamePixels(const std::string& location, RawStorage raw) {
  const test::TemporaryFolder folder;
  LiveCamera camera;
  camera.location = location;
  const auto feed = std::make_shared<EncodedFeed>();
  const LiveStreamPtr stream = makeLiveStream(camera, feed);
  ASSERT_TRUE(stream->open()) << location;
  StreamRecording recording(feed, {folder / "left.mkv", folder / "left.csv"}, raw,
                            StoredClock::now(), "");
  std::map<std::int64_t, cv::Mat> seen; // by stamp
  const auto deadline = StoredClock::now() + 20s;
  while (recording.counts().imageCount < 40 && StoredClock::now() < deadline && stream->grab()) {
    const cv::Mat image = stream->retrieve();
    const auto captured = stream->captureTime();
    if (!image.empty() && captured) {
      ASSERT_GE(captured->imageId, 0) << location;
      seen[captured->imageId] = image;
    }
  }
  recording.stop();
  EXPECT_FALSE(recording.counts().hasChangedPixels) << location;
  const std::vector<std::int64_t> stamps = recording.imageStamps();
  ASSERT_EQ(std::ssize(stamps), recording.counts().imageCount) << location;
  auto stored = StoredStream::open(folder / "left.mkv", "camera 'left'");
  ASSERT_TRUE(stored) << errorSentence(stored.error());
  int compared = 0;
  for (std::size_t k = 0; k < stamps.size(); k += 3) { // also with gaps
    const auto live = seen.find(stamps[k]);
    const auto image = stored->read(static_cast<std::int64_t>(k));
    ASSERT_TRUE(image) << location << ": " << errorSentence(image.error());
    if (live != seen.end()) {
      ++compared;
      EXPECT_EQ(cv::norm(*image, live->second, cv::NORM_INF), 0.0) << location << ' ' << k;
    }
  }
  EXPECT_GE(compared, 5) << location;
  const auto none = stored->read(std::ssize(stamps) + 5);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::EndedEarly);
}

TEST(StoredStream, ImagesStoredUnchangedHaveThePixelsTheyHadLive) {
  expectSamePixels("test:ball?width=320&height=240&encoding=mjpeg", RawStorage::Jpeg);
  expectSamePixels("test:smpte?width=320&height=240&encoding=h264", RawStorage::Jpeg);
  expectSamePixels("test:smpte?width=320&height=240", RawStorage::Lossless);
  for (const char* format : {"BGR", "RGB", "BGRx"}) {
    expectSamePixels(std::string("gst:videotestsrc is-live=true pattern=smpte ! video/x-raw,"
                                 "width=320,height=240,framerate=30/1,format=") +
                         format,
                     RawStorage::Lossless);
  }
}

TEST(StoredStream, RawImagesStoredAsJpegAreReportedAsChanged) {
  const test::TemporaryFolder folder;
  LiveCamera camera;
  camera.location = "test:smpte?width=320&height=240";
  const auto feed = std::make_shared<EncodedFeed>();
  const LiveStreamPtr stream = makeLiveStream(camera, feed);
  ASSERT_TRUE(stream->open());
  StreamRecording recording(feed, {folder / "left.mkv", folder / "left.csv"}, RawStorage::Jpeg,
                            StoredClock::now(), "");
  const auto deadline = StoredClock::now() + 20s;
  while (recording.counts().imageCount < 3 && StoredClock::now() < deadline && stream->grab()) {
  }
  recording.stop();
  EXPECT_TRUE(recording.counts().hasChangedPixels);
}

TEST(StoredStream, AFileThatIsNotThereIsNamed) {
  const auto opened = StoredStream::open("/nowhere/left.mkv", "camera 'left'");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::FileMissing);
  EXPECT_EQ(opened.error().field, "camera 'left'");
}

} // namespace
} // namespace dewpoint::tests
