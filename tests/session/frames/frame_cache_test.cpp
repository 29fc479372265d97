// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording.h"
#include "core/session/frames/frame_cache.h"
#include "core/session/frames/frame_previews.h"
#include "core/session/frames/live_frames.h"
#include "core/session/frames/recorded_frames.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <chrono>
#include <thread>

namespace dewpoint::tests {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr std::size_t kFrameBytes = std::size_t{3} * kWidth * kHeight;

/// A picture with its number in it, as gray and as the place of a bar.
cv::Mat numbered(std::int64_t frame) {
  cv::Mat picture(kHeight, kWidth, CV_8UC3,
                  cv::Scalar::all(static_cast<double>(40 + frame * 7 % 150)));
  const int at = static_cast<int>(frame % (kWidth - 8));
  cv::rectangle(picture, {at, 8, 8, 40}, cv::Scalar(30, 200, 90), cv::FILLED);
  return picture;
}

bool same(const FrameSetPtr& a, const FrameSetPtr& b) {
  return a && b && a->index == b->index && a->frames.size() == b->frames.size() &&
         cv::norm(a->frames[0]->image, b->frames[0]->image, cv::NORM_INF) == 0.0;
}

std::unique_ptr<FrameSetSource> open(const std::string& path) {
  RecordedCamera camera;
  camera.name = "left";
  camera.path = path;
  auto opened = openRecording({camera}, 0);
  EXPECT_TRUE(opened);
  return std::move(*opened);
}

/// Videos whose frames depend on each other, with key frames far apart.
class CompressedVideo : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(CompressedVideo, AnyOrderGivesThePicturesOfReadingInARow) {
  const test::TemporaryFolder home;
  const std::string path = home / GetParam().second;
  const char* code = GetParam().first;
  {
    cv::VideoWriter writer(path, cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]), 30.0,
                           {kWidth, kHeight});
    if (!writer.isOpened()) {
      GTEST_SKIP() << "this system cannot write " << code;
    }
    for (int k = 0; k < 200; ++k) {
      writer.write(numbered(k));
    }
  }
  const auto sequential = open(path);
  std::vector<FrameSetPtr> all;
  while (all.size() < 200) {
    all.push_back(sequential->next().value());
    ASSERT_NE(all.back(), nullptr);
  }
  const auto source = open(path);
  const auto library = makeRecordedFrameCache(*source, 20 * kFrameBytes);
  EXPECT_EQ(library->newestFrame(), 199);
  for (int step = 0; step < 300; ++step) {
    // Back by one, ahead by one, and jumps: 7919 is a prime.
    const std::int64_t jump = std::int64_t{step} / 10 * 7919 % 200;
    const std::int64_t frame =
        std::clamp<std::int64_t>(step % 20 < 10 ? jump - step % 10 : jump + step % 10, 0, 199);
    const auto found = library->at(frame);
    ASSERT_TRUE(found);
    ASSERT_TRUE(same(*found, all[static_cast<std::size_t>(frame)])) << frame;
    ASSERT_LE(library->memoryBytes(), 20 * kFrameBytes);
  }
  EXPECT_EQ(library->at(200).value(), nullptr);
  EXPECT_EQ(library->at(-1).value(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Codecs, CompressedVideo,
                         testing::Values(std::pair("mp4v", "a.mp4"), std::pair("avc1", "a.mp4"),
                                         std::pair("mp4v", "a.avi"), std::pair("MJPG", "a.avi")),
                         [](const auto& test) {
                           std::string name = std::string(test.param.first) + test.param.second;
                           std::erase_if(name, [](char c) { return c == '.'; });
                           return name;
                         });

TEST(FramePreviews, ShowTheFrameInSmallAndThinThemselves) {
  FramePreviews previews(40000);
  const auto set = [](std::int64_t index) {
    FrameSet frames;
    frames.index = index;
    frames.frames = {std::make_shared<const Frame>(Frame{index, {}, numbered(index)}), nullptr};
    return frames;
  };
  EXPECT_EQ(previews.at(0), nullptr);
  for (int k = 0; k < 100; ++k) {
    previews.add(set(k));
    ASSERT_LE(previews.memoryBytes(), 40000U);
  }
  for (const std::int64_t frame : {0, 33, 99}) {
    const FrameSetPtr small = previews.at(frame);
    ASSERT_NE(small, nullptr);
    EXPECT_EQ(small->index, frame);
    ASSERT_EQ(small->frames[0]->image.size(), cv::Size(kWidth, kHeight));
    EXPECT_EQ(small->frames[1], nullptr);
  }
  // The first one is itself: only the JPEG of a little larger picture stands between.
  EXPECT_LT(cv::norm(previews.at(0)->frames[0]->image, numbered(0), cv::NORM_L1) / kFrameBytes,
            12.0);
}

FrameSetPtr liveFrame(std::int64_t index) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  set->time = timeStamp(static_cast<double>(index) / 30.0);
  set->frames.push_back(
      std::make_shared<const Frame>(Frame{index + 5, set->time, numbered(index)}));
  set->frames.push_back(nullptr); // a camera that delivers nothing
  return set;
}

TEST(LiveFrames, KeepTheNewestAsTheyCameAndOlderOnesPacked) {
  constexpr std::size_t kMost = 100 * kFrameBytes;
  const auto library = makeLiveFrameCache(kMost);
  EXPECT_EQ(library->newestFrame(), -1);
  EXPECT_EQ(library->at(0).value(), nullptr);
  for (int index = 0; index < 600; ++index) {
    library->add(liveFrame(index));
    ASSERT_LE(library->memoryBytes(), kMost);
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
  EXPECT_EQ(library->newestFrame(), 599);
  EXPECT_TRUE(same(library->at(599).value(), liveFrame(599)));
  EXPECT_TRUE(same(library->at(590).value(), liveFrame(590))); // a quarter of 100 stays as it came
  const std::int64_t oldest = library->oldestFrame();
  const auto old = library->at(oldest).value();
  ASSERT_NE(old, nullptr);
  EXPECT_EQ(old->index, oldest);
  EXPECT_EQ(old->time, liveFrame(oldest)->time);
  EXPECT_EQ(old->frames[0]->index, oldest + 5);
  EXPECT_EQ(old->frames[0]->captureTime, liveFrame(oldest)->frames[0]->captureTime);
  EXPECT_EQ(old->frames[1], nullptr);
  // JPEG of quality 92: a few gray levels on the average.
  EXPECT_LT(cv::norm(old->frames[0]->image, numbered(oldest), cv::NORM_L1) / kFrameBytes, 6.0);
  EXPECT_EQ(library->at(oldest - 1).value(), nullptr);
  library->clear();
  EXPECT_EQ(library->memoryBytes(), 0U);
}

} // namespace
} // namespace dewpoint::tests
