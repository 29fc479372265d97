// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/background_suppression.h"
#include "core/color/color_classifier.h"
#include "core/color/color_learning.h"
#include "core/color/match_image.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

const ColorRange kReds{340.0, 20.0, 0.5, 1.0, 0.1, 0.9};
const cv::Rect kChair(10, 60, 40, 50); ///< red as well, and always there

cv::Mat roomWithChair() {
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  image(kChair) = cv::Scalar(30, 30, 200);
  return image;
}
cv::Mat withBall() {
  cv::Mat image = roomWithChair();
  cv::circle(image, {110, 50}, 12, cv::Scalar(40, 20, 220), cv::FILLED);
  return image;
}

TEST(FamiliarColor, WhatTheBackgroundImageShowedIsBlack) {
  const auto images =
      suppressBackgroundColors(kReds, {withBall(), withBall()}, {roomWithChair(), cv::Mat()});
  const cv::Mat match = matchImage(images[0], ColorClassifier(kReds));
  EXPECT_EQ(cv::countNonZero(match(kChair)), 0);
  EXPECT_GT(cv::countNonZero(match), 400); // the ball: pi 12^2 = 452
  EXPECT_EQ(images[0].at<cv::Vec3b>(5, 5), cv::Vec3b(90, 90, 90)) << "what does not match stays";
  EXPECT_EQ(cv::norm(images[1], withBall(), cv::NORM_INF), 0.0) << "no room, no change";
}

TEST(FamiliarColor, TheVerdictLeavesItOut) {
  ColorSample click;
  click.x = 110;
  click.y = 50;
  const std::vector<cv::Mat> images{withBall()};
  const auto sample = takeSample(images[0], click);
  ASSERT_TRUE(sample);
  const ColorAssessment blind = assessColorWithBackground(kReds, {*sample}, images, {});
  ASSERT_EQ(blind.distractors.size(), 1U);
  EXPECT_GT(blind.backgroundShare, 0.1); // 2000 of 19200 pixels
  const ColorAssessment knowing =
      assessColorWithBackground(kReds, {*sample}, images, {roomWithChair()});
  EXPECT_TRUE(knowing.distractors.empty());
  EXPECT_EQ(knowing.backgroundShare, 0.0);
  EXPECT_GT(knowing.separability, blind.separability);

  const auto learned = learnColorWithBackground({*sample}, images, {roomWithChair()});
  ASSERT_TRUE(learned);
  EXPECT_EQ(learned->range, learnColor({*sample}, images)->range);
  EXPECT_TRUE(learned->assessment.distractors.empty());
}

// What is handed on from learning to judging does not change what is judged: with an image that
// shows the click, one that does not, and a room that changes the first.
TEST(FamiliarColor, LearningAndJudgingAgreeToTheBit) {
  ColorSample click;
  click.x = 110;
  click.y = 50;
  const std::vector<cv::Mat> images{withBall(), cv::Mat(), withBall()};
  const auto sample = takeSample(images[0], click);
  ASSERT_TRUE(sample);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<cv::Mat> rooms =
        k == 0 ? std::vector<cv::Mat>() : std::vector{roomWithChair()};
    const auto learned = learnColorWithBackground({*sample}, images, rooms);
    ASSERT_TRUE(learned);
    const ColorAssessment anew =
        assessColorWithBackground(learned->range, {*sample}, images, rooms);
    EXPECT_EQ(learned->assessment.separability, anew.separability);
    EXPECT_EQ(learned->assessment.targetShare, anew.targetShare);
    EXPECT_EQ(learned->assessment.backgroundShare, anew.backgroundShare);
    EXPECT_EQ(learned->assessment.distractors.size(), anew.distractors.size());
    EXPECT_EQ(learned->assessment.suggestion, anew.suggestion);
  }
}

} // namespace
} // namespace dewpoint::tests
