// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_health.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using HealthClock = ImageHealth::Clock;
using Moment = HealthClock::duration; ///< since the camera was opened

/// A gray image; no two numbers have the same.
cv::Mat grayImage(int number) {
  return {48, 64, CV_8UC3, cv::Scalar(40 + number % 150, 40 + number / 150, 90)};
}

/// A camera at 30 images per second.
class WatchedCamera : public testing::Test {
protected:
  static constexpr Moment kInterval = std::chrono::duration_cast<Moment>(1s) / 30;

  WatchedCamera() { health_.restart(HealthClock::time_point()); }

  /// Sends images until a time, and collects the faults meanwhile.
  void sendUntil(Moment end, const std::function<cv::Mat(int)>& image = grayImage,
                 Moment interval = kInterval, Moment age = 10ms) {
    for (; now_ < end; now_ += interval) {
      const HealthClock::time_point arrived(now_);
      health_.add(image(++number_), arrived, arrived - age);
      note(arrived);
    }
  }
  void note(HealthClock::time_point at) {
    const auto fault = health_.fault(at);
    if (fault && (faults_.empty() || faults_.back() != fault->code)) {
      faults_.push_back(fault->code);
      begun_ = at - HealthClock::time_point();
    }
    isFaulty_ = fault.has_value();
  }

  ImageHealth health_;
  Moment now_{0};
  int number_ = 0;
  std::vector<ErrorCode> faults_; ///< in their order
  Moment begun_{0};               ///< when the last one was found
  bool isFaulty_ = false;
};

TEST_F(WatchedCamera, GoodImagesHaveNoFault) {
  sendUntil(10s);
  EXPECT_TRUE(faults_.empty());
}

TEST_F(WatchedCamera, BlackImagesAreFoundWithinASecond) {
  sendUntil(5s);
  sendUntil(7s, [](int number) {
    cv::Mat image(48, 64, CV_8UC3, cv::Scalar(number % 20, 3 + number / 20 % 20, 2));
    image.at<cv::Vec3b>(24, 32) = {255, 255, 255}; // a defective pixel
    return image;
  });
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesBlack});
  EXPECT_LT(begun_, 6s);
  sendUntil(7s + 2 * kInterval);
  EXPECT_FALSE(isFaulty_); // at once
}

TEST_F(WatchedCamera, AFrozenCameraIsFoundWithinASecond) {
  sendUntil(5s);
  sendUntil(7s, [](int) { return grayImage(7); });
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesFrozen}); // it is not said to repeat before
  EXPECT_LT(begun_, 6s);
  sendUntil(9s);
  EXPECT_FALSE(isFaulty_);
  EXPECT_EQ(faults_.size(), 1U);
}

TEST_F(WatchedCamera, ACameraThatSendsImagesTwiceRepeats) {
  sendUntil(5s);
  sendUntil(7s, [](int number) { return grayImage(number / 2); });
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesRepeat});
  EXPECT_LT(begun_, 6s);
}

TEST_F(WatchedCamera, ALoopRepeats) {
  sendUntil(5s);
  sendUntil(7s, [](int number) { return grayImage(1000 + number % 10); });
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesRepeat});
  EXPECT_LT(begun_, 6s);
}

TEST_F(WatchedCamera, AFewEqualImagesAreNoFault) {
  sendUntil(5s, [](int number) { return grayImage(number % 5 == 0 ? number - 1 : number); });
  EXPECT_TRUE(faults_.empty());
}

TEST_F(WatchedCamera, LateImagesAreFoundWithinASecond) {
  sendUntil(5s);
  sendUntil(7s, grayImage, kInterval, 800ms);
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesLate});
  EXPECT_LT(begun_, 6s);
  sendUntil(8s);
  EXPECT_FALSE(isFaulty_);
}

TEST_F(WatchedCamera, ADelayThatIsKnownIsNotLate) {
  health_ = ImageHealth(0.0, 0.4);
  health_.restart(HealthClock::time_point());
  sendUntil(5s, grayImage, kInterval, 800ms);
  EXPECT_TRUE(faults_.empty());
}

TEST_F(WatchedCamera, ASlowerCameraIsFoundWithinASecond) {
  sendUntil(6s);
  sendUntil(8s, grayImage, 2 * kInterval);
  ASSERT_EQ(faults_, std::vector{ErrorCode::ImagesFew});
  EXPECT_LT(begun_, 7s);
  EXPECT_EQ(health_.fault(HealthClock::time_point(8s))->detail,
            "fewer than 18 per second instead of 30");
  sendUntil(10s);
  EXPECT_FALSE(isFaulty_);
}

TEST_F(WatchedCamera, ACameraThatDoesNotReachItsRateIsSlow) {
  health_ = ImageHealth(60.0);
  health_.restart(HealthClock::time_point());
  sendUntil(1s);
  EXPECT_TRUE(faults_.empty()); // it may have to settle
  sendUntil(3s);
  EXPECT_EQ(faults_, std::vector{ErrorCode::ImagesFew});
}

TEST_F(WatchedCamera, ASilenceIsNotSlowness) {
  sendUntil(6s);
  note(HealthClock::time_point(6s + 900ms));
  now_ = 7s + 500ms;
  sendUntil(12s);
  EXPECT_TRUE(faults_.empty()); // nor is it slow when it goes on
}

TEST_F(WatchedCamera, AnotherConnectionForgetsTheImages) {
  sendUntil(2s, [](int) { return grayImage(7); });
  EXPECT_TRUE(isFaulty_);
  health_.restart(HealthClock::time_point(now_));
  EXPECT_FALSE(health_.fault(HealthClock::time_point(now_)));
}

TEST(ImageHealth, FaultsOfImagesAreToldFromOtherProblems) {
  EXPECT_TRUE(isImageFault(ErrorCode::ImagesBlack));
  EXPECT_TRUE(isImageFault(ErrorCode::ImagesFew));
  EXPECT_FALSE(isImageFault(ErrorCode::ConnectionLost));
  EXPECT_FALSE(isImageFault(ErrorCode::Canceled));
}

} // namespace
} // namespace dewpoint::tests
