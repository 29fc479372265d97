// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_rate.h"

#include <gtest/gtest.h>

#include <chrono>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using capture::ImageRate;

/// Images at even intervals.
class ImageRateTest : public testing::Test {
protected:
  void add(int count, std::chrono::milliseconds interval) {
    for (int k = 0; k < count; ++k) {
      rate_.add(now_ += interval);
    }
  }

  ImageRate rate_;
  ImageRate::Clock::time_point now_{1h};
};

TEST_F(ImageRateTest, IsThatOfEvenImages) {
  EXPECT_EQ(rate_.imagesPerSecond(), 0.0);
  add(1, 40ms);
  EXPECT_EQ(rate_.imagesPerSecond(), 0.0); // one image has no rate
  add(1, 40ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 25.0, 1e-9);
  add(20, 40ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 25.0, 1e-9);
}

TEST_F(ImageRateTest, FollowsAnotherRate) {
  add(30, 20ms);
  add(60, 100ms); // 80 ms * 0.9^60 = 0.14 ms are left
  EXPECT_NEAR(rate_.imagesPerSecond(), 10.0, 0.02);
  add(60, 20ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 50.0, 0.4);
}

TEST_F(ImageRateTest, APauseIsNoRate) {
  add(30, 20ms);
  add(1, 5000ms); // it was frozen
  EXPECT_NEAR(rate_.imagesPerSecond(), 50.0, 1e-6);
  add(1, 20ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 50.0, 1e-6);
}

TEST_F(ImageRateTest, PausesInARowAreARate) {
  add(30, 20ms);
  add(100, 1000ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 1.0, 1e-3);
}

TEST_F(ImageRateTest, ANewConnectionKeepsTheRate) {
  add(30, 20ms);
  rate_.restart();
  add(1, 100ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 50.0, 1e-6);
}

TEST_F(ImageRateTest, ImagesAtTheSameTimeDoNotCount) {
  add(2, 20ms);
  add(5, 0ms);
  EXPECT_NEAR(rate_.imagesPerSecond(), 50.0, 1e-6);
}

} // namespace
} // namespace dewpoint::tests
