// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_times.h"
#include "core/capture/gstreamer/gst_image.h"
#include "core/capture/gstreamer/gst_library.h"
#include "core/capture/gstreamer/gst_stream.h"
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/gstreamer/stream_recording.h"
#include "core/capture/recording.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <fstream>
#include <functional>
#include <gst/gst.h>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using RecordingClock = StreamRecording::Clock;

/// A live camera that is read by a thread of its own.
class ReadCamera {
public:
  explicit ReadCamera(const std::string& location) {
    LiveCamera camera;
    camera.name = "left";
    camera.location = location;
    feed = std::make_shared<EncodedFeed>();
    stream_ = makeLiveStream(camera, feed);
    const auto opened = stream_->open();
    EXPECT_TRUE(opened) << opened.error();
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested() && stream_->grab()) {
        if (const cv::Mat image = stream_->retrieve(); !image.empty() && first.empty()) {
          first = image;
        }
      }
    });
  }
  ~ReadCamera() {
    thread_.request_stop();
    thread_.join();
  }

  EncodedFeedPtr feed;
  cv::Mat first;

private:
  LiveStreamPtr stream_;
  std::jthread thread_;
};

/// Waits until a condition holds; false when it never does.
bool waitUntil(const std::function<bool()>& holds) {
  const auto deadline = RecordingClock::now() + 20s;
  while (!holds() && RecordingClock::now() < deadline) {
    std::this_thread::sleep_for(10ms);
  }
  return holds();
}

RecordedCounts waitForImages(const StreamRecording& recording, std::int64_t count) {
  waitUntil([&] { return recording.counts().imageCount >= count; });
  return recording.counts();
}

StreamFiles filesIn(const test::TemporaryFolder& folder) {
  return {folder / "left.mkv", folder / "left.csv"};
}

RecordedCamera recordedIn(const test::TemporaryFolder& folder) {
  RecordedCamera camera;
  camera.name = "left";
  camera.path = folder / "left.mkv";
  camera.timesFile = folder / "left.csv";
  return camera;
}

/// Images in a video, counted one by one.
std::int64_t countedImages(const std::string& file) {
  cv::VideoCapture video(file, cv::CAP_FFMPEG);
  std::int64_t count = 0;
  while (video.grab()) {
    ++count;
  }
  return count;
}

void cutTable(const std::string& file, std::size_t linesLess, const std::string& rest) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  in.close();
  lines.resize(lines.size() - linesLess);
  std::ofstream out(file);
  for (const std::string& line : lines) {
    out << line << '\n';
  }
  out << rest;
}

TEST(StreamRecording, OpensAsARecordingWithItsTimes) {
  for (const char* encoding : {"raw", "mjpeg", "h264"}) {
    const test::TemporaryFolder folder;
    ReadCamera camera(std::string("test:ball?width=320&height=240&rate=30&encoding=") + encoding);
    StreamRecording recording(camera.feed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now(),
                              "camera 'left'");
    waitForImages(recording, 40);
    const auto begin = RecordingClock::now();
    recording.stop();
    EXPECT_LT(RecordingClock::now() - begin, 1s);
    const RecordedCounts counts = recording.counts();
    EXPECT_FALSE(counts.problem) << errorSentence(*counts.problem);
    EXPECT_GE(counts.imageCount, 40) << encoding;
    EXPECT_EQ(counts.droppedImageCount, 0) << encoding;
    EXPECT_NEAR(counts.framesPerSecond, 30.0, 0.1);
    EXPECT_EQ(counts.origin, TimeOrigin::Driver);
    EXPECT_GT(counts.byteCount, 1000);
    EXPECT_EQ(countedImages(folder / "left.mkv"), counts.imageCount) << encoding;
    EXPECT_EQ(completenessOf(folder / "left.csv"), TableCompleteness::Complete);

    auto source = openRecording({recordedIn(folder)}, 0);
    ASSERT_TRUE(source) << errorSentence(source.error());
    EXPECT_NEAR((*source)->framesPerSecond(), 30.0, 0.1);
    EXPECT_EQ((*source)->frameCount(), counts.imageCount);
    for (std::int64_t k = 0; k < counts.imageCount; ++k) {
      const auto set = (*source)->next();
      ASSERT_TRUE(set) << errorSentence(set.error());
      ASSERT_TRUE(*set && (*set)->frames[0]) << k;
      EXPECT_NEAR(seconds((*set)->frames[0]->captureTime), static_cast<double>(k) / 30.0, 1e-3);
    }
  }
}

TEST(StreamRecording, EncodedImagesStayAsTheyAre) {
  const test::TemporaryFolder folder;
  ReadCamera camera("test:ball?width=320&height=240&encoding=mjpeg");
  std::vector<std::vector<unsigned char>> sent;
  std::mutex mutex;
  const auto passed = std::make_shared<EncodedFeed>();
  camera.feed->connect([&](const EncodedImage& image) {
    GstBuffer* buffer = gst_sample_get_buffer(image.sample.get());
    std::scoped_lock lock(mutex);
    sent.emplace_back(gst_buffer_get_size(buffer));
    gst_buffer_extract(buffer, 0, sent.back().data(), sent.back().size());
    passed->put(image);
  });
  StreamRecording recording(passed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now() - 1s,
                            "");
  waitForImages(recording, 10);
  camera.feed->disconnect();
  recording.stop();
  cv::VideoCapture packets(folder / "left.mkv", cv::CAP_FFMPEG, {cv::CAP_PROP_FORMAT, -1});
  cv::Mat bytes;
  std::size_t k = sent.size() - static_cast<std::size_t>(recording.counts().imageCount);
  for (; packets.read(bytes); ++k) {
    ASSERT_LT(k, sent.size());
    ASSERT_EQ(bytes.total(), sent[k].size());
    EXPECT_TRUE(std::equal(sent[k].begin(), sent[k].end(), bytes.data));
  }
  EXPECT_EQ(k, sent.size());
}

TEST(StreamRecording, RawImagesReadBackWithTheirColors) {
  for (const RawStorage raw : {RawStorage::Jpeg, RawStorage::Lossless}) {
    const test::TemporaryFolder folder;
    ReadCamera camera("gst:videotestsrc is-live=true pattern=smpte ! "
                      "video/x-raw,format=YUY2,width=320,height=240,framerate=30/1");
    StreamRecording recording(camera.feed, filesIn(folder), raw, RecordingClock::now(), "");
    EXPECT_GE(waitForImages(recording, 5).imageCount, 5);
    recording.stop();
    cv::VideoCapture video(folder / "left.mkv", cv::CAP_FFMPEG);
    cv::Mat image;
    ASSERT_TRUE(video.read(image));
    ASSERT_FALSE(camera.first.empty());
    for (int bar = 0; bar < 7; ++bar) {
      const cv::Rect middle(15 + bar * 46, 40, 14, 60);
      const cv::Scalar difference = cv::mean(image(middle)) - cv::mean(camera.first(middle));
      EXPECT_LT(cv::norm(difference), 5.0) << bar << ": " << difference; // converters round
    }
    if (raw == RawStorage::Lossless) {
      EXPECT_EQ(recording.counts().byteCount / recording.counts().imageCount / (320 * 240 * 2), 1);
    }
  }
}

TEST(StreamRecording, LosslessImagesKeepEachColor) {
  ASSERT_TRUE(startGStreamer());
  const test::TemporaryFolder folder;
  const auto feed = std::make_shared<EncodedFeed>();
  StreamRecording recording(feed, filesIn(folder), RawStorage::Lossless, RecordingClock::now(), "");
  cv::RNG random(7);
  std::vector<cv::Mat> sent;
  for (int k = 0; k < 5; ++k) {
    cv::Mat image(49, 67, CV_8UC3); // rows that are no multiple of four bytes
    random.fill(image, cv::RNG::UNIFORM, 0, 256);
    sent.push_back(image);
    feed->put({std::shared_ptr<GstSample>(sampleOf(image), gst_sample_unref),
               {RecordingClock::now(), TimeOrigin::Arrival}});
  }
  EXPECT_EQ(waitForImages(recording, 5).imageCount, 5);
  recording.stop();
  EXPECT_FALSE(recording.counts().hasChangedPixels);
  cv::VideoCapture video(folder / "left.mkv", cv::CAP_FFMPEG);
  for (const cv::Mat& image : sent) {
    cv::Mat read;
    ASSERT_TRUE(video.read(read));
    EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0);
  }
}

TEST(StreamRecording, SeeksToAnyImage) {
  const test::TemporaryFolder folder;
  ReadCamera camera("test:ball?width=160&height=120&rate=60&encoding=mjpeg");
  StreamRecording recording(camera.feed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now(),
                            "");
  waitForImages(recording, 150);
  recording.stop();
  auto source = openRecording({recordedIn(folder)}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  std::vector<cv::Mat> images;
  for (auto set = (*source)->next(); set && *set; set = (*source)->next()) {
    images.push_back((*set)->frames[0] ? (*set)->frames[0]->image : cv::Mat());
  }
  ASSERT_GE(images.size(), 145U);
  for (const std::size_t frame : {100U, 7U, 144U, 60U, 0U}) {
    ASSERT_TRUE((*source)->seek(static_cast<std::int64_t>(frame)));
    const auto set = (*source)->next();
    ASSERT_TRUE(set && *set && (*set)->frames[0]);
    EXPECT_EQ(cv::norm((*set)->frames[0]->image, images[frame], cv::NORM_INF), 0.0) << frame;
  }
}

TEST(StreamRecording, ATableThatWasCutOffMatchesItsVideo) {
  const test::TemporaryFolder folder;
  ReadCamera camera("test:ball?width=160&height=120&encoding=mjpeg");
  StreamRecording recording(camera.feed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now(),
                            "");
  waitForImages(recording, 20);
  recording.stop();
  const std::int64_t images = recording.counts().imageCount;
  cutTable(folder / "left.csv", 4, "99,0.1"); // also in the middle of a line
  EXPECT_EQ(completenessOf(folder / "left.csv"), TableCompleteness::CutOff);
  const auto fewerTimes = openRecording({recordedIn(folder)}, 0);
  ASSERT_TRUE(fewerTimes) << errorSentence(fewerTimes.error());
  EXPECT_EQ((*fewerTimes)->frameCount(), images - 3);
  cutTable(folder / "left.csv", 1,
           "17,50.1,driver\n18,50.2,driver\n19,50.3,driver\n20,50.4,driver\n"
           "21,50.5,driver\n22,50.6,driver\n23,50.7,driver\n");
  const auto moreTimes = openRecording({recordedIn(folder)}, 30);
  ASSERT_TRUE(moreTimes) << errorSentence(moreTimes.error());
}

TEST(StreamRecording, AFullDiskIsOneProblemAndTheCameraGoesOn) {
  const test::TemporaryFolder folder;
  ReadCamera camera("test:ball?width=160&height=120&encoding=mjpeg");
  for (const StreamFiles& files :
       {StreamFiles{"/dev/full", folder / "a.csv"}, StreamFiles{folder / "b.mkv", "/dev/full"}}) {
    StreamRecording recording(camera.feed, files, RawStorage::Jpeg, RecordingClock::now(),
                              "camera 'left'");
    waitUntil([&] { return recording.counts().problem.has_value(); });
    const RecordedCounts counts = recording.counts();
    ASSERT_TRUE(counts.problem);
    EXPECT_EQ(counts.problem->code, ErrorCode::FileUnwritable);
    EXPECT_EQ(counts.problem->file, "/dev/full");
    EXPECT_EQ(counts.problem->field, "camera 'left'");
    EXPECT_NE(errorSentence(*counts.problem).find("pace left"), std::string::npos)
        << errorSentence(*counts.problem);
    const auto begin = RecordingClock::now();
    recording.stop();
    EXPECT_LT(RecordingClock::now() - begin, 1s);
  }
  const auto before = camera.feed->imageCount();
  EXPECT_TRUE(waitUntil([&] { return camera.feed->imageCount() > before; }));
}

TEST(StreamRecording, StartsAndStopsWhileTheCameraRuns) {
  ReadCamera camera("test:ball?width=160&height=120&encoding=h264");
  for (int take = 0; take < 3; ++take) {
    const test::TemporaryFolder folder;
    StreamRecording recording(camera.feed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now(),
                              "");
    waitForImages(recording, 8); // it waits for a key frame
    recording.stop();
    EXPECT_EQ(countedImages(folder / "left.mkv"), recording.counts().imageCount);
    EXPECT_GE(recording.counts().imageCount, 8);
  }
}

TEST(StreamRecording, AChangedFormatIsReportedAndKeepsTheFile) {
  const test::TemporaryFolder folder;
  ReadCamera small("test:ball?width=160&height=120&encoding=mjpeg");
  ReadCamera large("test:ball?width=320&height=240&encoding=mjpeg");
  const auto feed = std::make_shared<EncodedFeed>();
  const auto pass = [feed](const EncodedImage& image) { feed->put(image); };
  StreamRecording recording(feed, filesIn(folder), RawStorage::Jpeg, RecordingClock::now(), "");
  small.feed->connect(pass);
  waitForImages(recording, 5);
  small.feed->disconnect();
  large.feed->connect(pass);
  EXPECT_TRUE(waitUntil(
      [&] { return recording.counts().problem && recording.counts().droppedImageCount > 0; }));
  large.feed->disconnect();
  small.feed->connect(pass);
  const auto before = recording.counts();
  ASSERT_TRUE(before.problem);
  EXPECT_NE(before.problem->detail.find("320 x 240"), std::string::npos);
  EXPECT_GT(before.droppedImageCount, 0);
  waitForImages(recording, before.imageCount + 5);
  small.feed->disconnect();
  recording.stop();
  EXPECT_GE(recording.counts().imageCount, before.imageCount + 5);
  EXPECT_EQ(countedImages(folder / "left.mkv"), recording.counts().imageCount);
}

} // namespace
} // namespace dewpoint::tests
