// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_motion_messages.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Camera 1, bumped at 10 s in frame 300.
CameraMotionReport bumped(std::size_t camera = 1) {
  CameraMotionReport report;
  report.event.camera = camera;
  report.event.frame = 300;
  report.event.time = timeStamp(10.0);
  return report;
}

CameraMotionReport solved(std::size_t camera = 1) {
  CameraMotionReport report = bumped(camera);
  report.newPose.emplace();
  return report;
}

CameraMotionReport back() {
  CameraMotionReport report = solved();
  report.isBackInPose = true;
  return report;
}

/// The stages that are told at a moment.
std::vector<CameraMotionStage> told(CameraMotionMessages& news,
                                    const std::vector<CameraMotionReport>& reports, double now) {
  std::vector<CameraMotionStage> stages;
  for (const auto& item : news.update(reports, now).messages) {
    stages.push_back(item.stage);
  }
  return stages;
}

using Stages = std::vector<CameraMotionStage>;

TEST(CameraMotionMessages, APoseIsWaitedForThreeSeconds) {
  EXPECT_EQ(stageOf(bumped(), 10.0), CameraMotionStage::Waiting);
  EXPECT_EQ(stageOf(bumped(), 13.0), CameraMotionStage::Waiting);
  EXPECT_EQ(stageOf(bumped(), 13.1), CameraMotionStage::Unsolvable);
  EXPECT_EQ(stageOf(solved(), 20.0), CameraMotionStage::Solved);
  EXPECT_EQ(stageOf(back(), 20.0), CameraMotionStage::Back); // whatever is known of its pose
}

TEST(CameraMotionMessages, EachStageIsToldOnce) {
  CameraMotionMessages news;
  EXPECT_EQ(told(news, {}, 9.0), Stages{});
  EXPECT_EQ(told(news, {bumped()}, 10.0), Stages{CameraMotionStage::Waiting});
  EXPECT_EQ(told(news, {bumped()}, 11.0), Stages{});
  EXPECT_EQ(told(news, {bumped()}, 14.0), Stages{CameraMotionStage::Unsolvable});
  EXPECT_EQ(told(news, {solved()}, 15.0), Stages{CameraMotionStage::Solved});
  EXPECT_EQ(told(news, {back()}, 16.0), Stages{CameraMotionStage::Back});
  EXPECT_EQ(told(news, {back()}, 17.0), Stages{});
}

TEST(CameraMotionMessages, APoseThatComesAndGoesStaysOnOffer) {
  CameraMotionMessages news;
  EXPECT_EQ(told(news, {solved()}, 10.5), Stages{CameraMotionStage::Solved});
  EXPECT_EQ(told(news, {bumped()}, 11.0), Stages{}); // not known for a while
  EXPECT_EQ(told(news, {bumped()}, 15.0), Stages{});
}

TEST(CameraMotionMessages, WhenOneIsDealtWithTheOthersAreToldAgain) {
  CameraMotionMessages news;
  EXPECT_EQ(told(news, {solved(0), solved(1)}, 11.0),
            (Stages{CameraMotionStage::Solved, CameraMotionStage::Solved}));
  const auto after = news.update({solved(1)}, 12.0);
  EXPECT_TRUE(after.withdrawsEarlierMessages);
  ASSERT_EQ(after.messages.size(), 1U);
  EXPECT_EQ(after.messages[0].report.event.camera, 1U);
  EXPECT_FALSE(news.update({solved(1)}, 13.0).withdrawsEarlierMessages);
}

TEST(CameraMotionMessages, AnotherRunBeginsAnew) {
  CameraMotionMessages news;
  (void)news.update({solved()}, 11.0);
  news.clear();
  const auto again = news.update({solved()}, 11.0);
  EXPECT_FALSE(again.withdrawsEarlierMessages);
  EXPECT_EQ(again.messages.size(), 1U);
}

} // namespace
} // namespace dewpoint::tests
