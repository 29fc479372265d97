// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/observation/background/foreground_model.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

const cv::Rect kThing(20, 10, 12, 30);
const cv::Rect kShadow(40, 40, 20, 10);

/// A gray-brown wall with noise of 3 gray levels; frame by frame anew.
cv::Mat wall(std::uint32_t frame) {
  cv::Mat image(60, 80, CV_8UC3);
  const RandomStream stream(5, frame, 0, RandomPurpose::Noise);
  const cv::Vec3d color(90.0, 110.0, 130.0);
  for (int i = 0; i < image.rows * image.cols; ++i) {
    const auto normal = stream.normal4(static_cast<std::uint32_t>(i));
    auto& pixel = image.at<cv::Vec3b>(i / image.cols, i % image.cols);
    for (int c = 0; c < 3; ++c) {
      pixel[c] = cv::saturate_cast<unsigned char>(color[c] + 3.0 * normal[std::size_t(c)]);
    }
  }
  return image;
}

cv::Mat withThing(std::uint32_t frame) {
  cv::Mat image = wall(frame);
  image(kThing).setTo(cv::Scalar(160, 60, 40));
  cv::Mat shadow;
  image(kShadow).convertTo(shadow, CV_8UC3, 0.7); // the same tint, darker
  shadow.copyTo(image(kShadow));
  return image;
}

class ForegroundModels : public testing::TestWithParam<BackgroundMethod> {};

TEST_P(ForegroundModels, FindTheThingButNotItsShadow) {
  ForegroundSettings settings;
  settings.method = GetParam();
  const auto model = makeForegroundModel(settings);
  for (std::uint32_t frame = 0; frame < 30; ++frame) {
    model->learn(wall(frame));
  }
  cv::Mat mask;
  model->subtract(wall(30), cv::Mat(), mask);
  EXPECT_LT(cv::countNonZero(mask), 50); // 1 % of the pixels
  model->subtract(withThing(31), cv::Mat(), mask);
  EXPECT_GT(cv::countNonZero(mask(kThing)), 0.95 * kThing.area());
  EXPECT_LT(cv::countNonZero(mask(kShadow)), 0.1 * kShadow.area());
  EXPECT_EQ(cv::countNonZero(mask) - cv::countNonZero(mask == 255), 0);
}

INSTANTIATE_TEST_SUITE_P(All, ForegroundModels,
                         testing::Values(BackgroundMethod::Running, BackgroundMethod::Mog2,
                                         BackgroundMethod::Knn));

TEST(CopyableForeground, IsTheRunningModelOnlyAndGoesOnWithTheSameBits) {
  ForegroundSettings settings;
  for (const BackgroundMethod other : {BackgroundMethod::Mog2, BackgroundMethod::Knn}) {
    settings.method = other;
    EXPECT_EQ(copyableForeground(makeForegroundModel(settings).get()), nullptr);
  }
  EXPECT_EQ(copyableForeground(nullptr), nullptr);
  settings.method = BackgroundMethod::Running;
  const auto model = makeForegroundModel(settings);
  for (std::uint32_t frame = 0; frame < 10; ++frame) {
    model->learn(wall(frame));
  }
  const CopyableForeground* const copyable = copyableForeground(model.get());
  ASSERT_NE(copyable, nullptr);
  EXPECT_GT(copyable->memoryBytes(), 60U * 80U);
  const auto copy = copyable->clone();
  cv::Mat mask;
  cv::Mat maskOfCopy;
  for (std::uint32_t frame = 10; frame < 13; ++frame) {
    model->subtract(withThing(frame), cv::Mat(), mask);
    copy->subtract(withThing(frame), cv::Mat(), maskOfCopy);
    EXPECT_EQ(cv::countNonZero(mask != maskOfCopy), 0);
  }
}

TEST(RunningBackground, DoesNotLearnWhatIsToBeKept) {
  ForegroundSettings settings;
  settings.memoryFrameCount = 20.0;
  for (const bool kept : {false, true}) {
    const auto model = makeForegroundModel(settings);
    for (std::uint32_t frame = 0; frame < 10; ++frame) {
      model->learn(wall(frame));
    }
    cv::Mat keep = cv::Mat::zeros(60, 80, CV_8UC1);
    keep(kThing).setTo(kept ? 255 : 0);
    cv::Mat mask;
    for (std::uint32_t frame = 10; frame < 150; ++frame) {
      model->subtract(withThing(frame), keep, mask);
    }
    if (kept) {
      EXPECT_GT(cv::countNonZero(mask(kThing)), 0.95 * kThing.area());
    } else { // long past the memory
      EXPECT_LT(cv::countNonZero(mask(kThing)), 0.05 * kThing.area());
    }
  }
}

} // namespace
} // namespace dewpoint::tests
