// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_schedule.h"
#include "core/capture/numbered_files.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using Pictures = CaptureSchedule::CameraImages;

/// The numbers of the pictures of a camera, frame by frame; -1: none.
std::vector<std::int64_t> numbers(const CaptureSchedule& schedule, std::size_t camera) {
  std::vector<std::int64_t> found;
  for (std::int64_t frame = 0; frame < schedule.frameCount(); ++frame) {
    const auto picture = schedule.imageAt(camera, frame);
    found.push_back(picture ? picture->imageIndex : -1);
  }
  return found;
}

using Numbers = std::vector<std::int64_t>;

TEST(CaptureSchedule, TakesPicturesOneByOneUntilTheShortestCameraEnds) {
  const CaptureSchedule schedule({{.imageCount = 5}, {.imageCount = 3}}, 10.0);
  EXPECT_EQ(schedule.frameCount(), 3);
  EXPECT_EQ(numbers(schedule, 0), (Numbers{0, 1, 2}));
  EXPECT_DOUBLE_EQ(schedule.imageAt(0, 2)->time, 0.2);
}

TEST(CaptureSchedule, TakesTheNearestPictureOfALateCamera) {
  const CaptureSchedule schedule({{.imageCount = 4}, {.imageCount = 4, .delay = 0.11}}, 10.0);
  EXPECT_EQ(numbers(schedule, 1), (Numbers{1, 2, 3, -1}));
  EXPECT_NEAR(schedule.imageAt(1, 0)->time, -0.01, 1e-12);
}

TEST(CaptureSchedule, HasNoPictureWhereOneIsMissing) {
  const CaptureSchedule schedule(
      {{.imageCount = 6}, {.imageCount = 4, .sequenceNumbers = {0, 1, 4, 5}}}, 10.0);
  EXPECT_EQ(schedule.frameCount(), 6);
  EXPECT_EQ(numbers(schedule, 1), (Numbers{0, 1, -1, -1, 2, 3}));
}

TEST(CaptureSchedule, PairsByTime) {
  // The second camera begins later, and leaves out half a second.
  const CaptureSchedule schedule(
      {{.imageCount = 9, .times = {{10.0, 10.1, 10.2, 10.3, 10.4, 10.5, 10.6, 10.7, 10.8}}},
       {.imageCount = 4, .times = {{10.22, 10.31, 10.72, 10.83}}}},
      10.0);
  EXPECT_EQ(numbers(schedule, 0), (Numbers{2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(numbers(schedule, 1), (Numbers{0, 1, -1, -1, -1, 2}));
  EXPECT_NEAR(schedule.imageAt(1, 1)->time, 0.09, 1e-9);
}

TEST(CaptureSchedule, CountsADelayBesideTimes) {
  const CaptureSchedule schedule({{.imageCount = 3, .times = {{0.0, 0.1, 0.2}}},
                                  {.imageCount = 4, .delay = 0.1, .times = {{0.0, 0.1, 0.2, 0.3}}}},
                                 10.0);
  EXPECT_EQ(numbers(schedule, 1), (Numbers{1, 2, 3}));
}

TEST(CaptureSchedule, LetsASlowCameraBeWithoutAPictureInBetween) {
  const std::vector<Pictures> cameras{{.imageCount = 5, .times = {{0.0, 0.1, 0.2, 0.3, 0.4}}},
                                      {.imageCount = 3, .times = {{0.0, 0.2, 0.4}}}};
  EXPECT_NEAR(CaptureSchedule::highestRateOf(cameras), 10.0, 1e-9);
  EXPECT_EQ(numbers(CaptureSchedule(cameras, 10.0), 1), (Numbers{0, -1, 1, -1, 2}));
}

TEST(CaptureSchedule, HasNoFramesOfCamerasThatNeverRanTogether) {
  const CaptureSchedule schedule(
      {{.imageCount = 2, .times = {{0.0, 0.1}}}, {.imageCount = 2, .times = {{5.0, 5.1}}}}, 10.0);
  EXPECT_EQ(schedule.frameCount(), 0);
}

TEST(NumberedFiles, GapsAreFoundByNumbers) {
  EXPECT_EQ(sequenceNumbersOf({"f/a_001.png", "f/a_002.png", "f/a_004.png"}), (Numbers{0, 1, 3}));
  EXPECT_EQ(sequenceNumbersOf({"10.png", "20.png", "30.png", "60.png"}), (Numbers{0, 1, 2, 5}));
}

TEST(NumberedFiles, NoGapIsFoundWhereThereIsNoSequence) {
  EXPECT_TRUE(sequenceNumbersOf({"1.png", "2.png", "3.png"}).empty());     // whole
  EXPECT_TRUE(sequenceNumbersOf({"a1.png", "b2.png", "a5.png"}).empty());  // other names
  EXPECT_TRUE(sequenceNumbersOf({"first.png", "2.png", "5.png"}).empty()); // no number
  EXPECT_TRUE(sequenceNumbersOf({"1000.png", "1033.png", "1067.png", "1101.png"}).empty()); // times
  EXPECT_TRUE(sequenceNumbersOf({"1.png", "2.png", "3.png", "90.png"}).empty()); // a stray one
}

TEST(NumberedFiles, TheNumberAtTheEndOfANameIsRead) {
  EXPECT_EQ(trailingNumber("cam_07"), 7);
  EXPECT_EQ(trailingNumber("left"), std::nullopt);
  EXPECT_EQ(trailingNumber("1234567890123456789"), std::nullopt);
}

} // namespace
} // namespace dewpoint::tests
