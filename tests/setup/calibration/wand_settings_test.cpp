// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_settings.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Project withBalls(int count) {
  Project project = test::twoCameraProject();
  const Target ball = project.targets.front();
  project.targets.clear();
  for (int k = 0; k < count; ++k) {
    project.targets.push_back(ball);
    project.targets.back().name = std::string(1, static_cast<char>('a' + k));
  }
  return project;
}

MarkedInstant at(double seconds, WandEvent role) {
  return {static_cast<std::int64_t>(30.0 * seconds), seconds, role};
}

TEST(WandSettings, BallsAreThoseThatAreNamedOrTheFirstOnes) {
  using Names = std::vector<std::string>;
  WandSettings wish;
  EXPECT_EQ(selectedTargets(wish, withBalls(0)), Names{});
  EXPECT_EQ(selectedTargets(wish, withBalls(2)), Names{"a"});
  wish.ballTarget = "b";
  EXPECT_EQ(selectedTargets(wish, withBalls(2)), Names{"b"});
  wish.usesStick = true;
  EXPECT_EQ(selectedTargets(wish, withBalls(3)), (Names{"b", "a"})); // another than the first end
  wish.secondBallTarget = "c";
  EXPECT_EQ(selectedTargets(wish, withBalls(3)), (Names{"b", "c"}));
  EXPECT_EQ(selectedTargets(wish, withBalls(2)), (Names{"b", "a"})); // "c" was removed
  EXPECT_EQ(selectedTargets(wish, withBalls(1)), Names{"a"});
}

TEST(WandSettings, TheFirstObstacleIsNamed) {
  WandSettings wish;
  Project oneCamera = withBalls(0);
  oneCamera.cameras.pop_back();
  EXPECT_EQ(obstacleOf(wish, {}, oneCamera), WandObstacle::TooFewCameras);
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(0)), WandObstacle::NoBall);
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(1)), WandObstacle::None);
  wish.usesStick = true;
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(1)), WandObstacle::NoSecondBall);
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(2)), WandObstacle::None);
  wish.ballTarget = wish.secondBallTarget = "b";
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(2)), WandObstacle::SameBallTwice);
}

TEST(WandSettings, ADistanceAndAFallNeedBothMoments) {
  WandSettings wish;
  wish.scaleSource = WandScaleSource::Distance;
  std::vector<MarkedInstant> instants{at(1.0, WandEvent::DistanceFrom)};
  EXPECT_EQ(obstacleOf(wish, instants, withBalls(1)), WandObstacle::IncompleteDistance);
  instants.push_back(at(2.0, WandEvent::DistanceTo));
  EXPECT_EQ(obstacleOf(wish, instants, withBalls(1)), WandObstacle::None);
  instants.push_back(at(3.0, WandEvent::FallEnds));
  EXPECT_EQ(obstacleOf(wish, instants, withBalls(1)), WandObstacle::IncompleteFall);
  instants.push_back(at(2.5, WandEvent::FallBegins));
  EXPECT_EQ(obstacleOf(wish, instants, withBalls(1)), WandObstacle::None);
  wish.usesStick = true; // whose length is the size: no distance is asked for
  EXPECT_EQ(obstacleOf(wish, {}, withBalls(2)), WandObstacle::None);
}

TEST(WandSettings, OptionsSayWhatWasDecided) {
  WandSettings wish;
  wish.scaleSource = WandScaleSource::Distance;
  wish.touchedDistance = 1.5;
  wish.estimatesTimeOffsets = true;
  wish.initialPositionError = 0.3;
  wish.usesOnlySelectedFrames = true;
  const std::vector<MarkedInstant> instants{
      at(1.0, WandEvent::Floor), at(2.0, WandEvent::DistanceFrom), at(3.0, WandEvent::DistanceTo),
      at(4.0, WandEvent::Floor), at(5.0, WandEvent::FallBegins),   at(5.5, WandEvent::FallEnds)};
  const WandOptions options = toWandOptions(wish, instants, withBalls(1), FrameSpan{10, 99});
  EXPECT_EQ(options.targets, std::vector<std::string>{"a"});
  ASSERT_TRUE(options.touchedDistance);
  EXPECT_EQ(options.touchedDistance->meters, 1.5);
  EXPECT_EQ(options.floorTimes, (std::vector<double>{1.0, 4.0}));
  ASSERT_TRUE(options.freeFallSpan);
  EXPECT_EQ((*options.freeFallSpan)[1], 5.5);
  EXPECT_TRUE(options.estimatesTimeOffsets);
  EXPECT_FALSE(options.estimatesFocalLengths);
  EXPECT_EQ(options.initialPositionError, 0.3);
  EXPECT_EQ(options.firstFrame, 10);
  EXPECT_EQ(options.endFrame, 100); // one past the last
}

TEST(WandSettings, AStickLeavesOutWhatIsOfOneBall) {
  WandSettings wish;
  wish.usesStick = true;
  wish.stickLength = 0.7;
  wish.scaleSource = WandScaleSource::Diameter;
  EXPECT_EQ(toWandOptions(wish, {}, withBalls(2)).stickLength, 0.7);
  EXPECT_FALSE(toWandOptions(wish, {}, withBalls(2)).usesBallDiameter);
  wish.usesStick = false;
  EXPECT_EQ(toWandOptions(wish, {}, withBalls(2)).stickLength, 0.0);
  EXPECT_TRUE(toWandOptions(wish, {}, withBalls(2)).usesBallDiameter);
  EXPECT_FALSE(toWandOptions(wish, {}, withBalls(2), FrameSpan{3, 4}).endFrame); // not asked for
}

TEST(WandSettings, OnlyTheFloorIsTouchedOften) {
  std::vector<MarkedInstant> instants;
  addInstant(instants, at(5.0, WandEvent::Floor));
  addInstant(instants, at(2.0, WandEvent::Floor));
  addInstant(instants, at(2.0, WandEvent::Floor)); // the same again
  addInstant(instants, at(3.0, WandEvent::FallBegins));
  addInstant(instants, at(4.0, WandEvent::FallBegins)); // in place of the one before
  ASSERT_EQ(instants.size(), 3U);
  EXPECT_EQ(instants[0].recordingTime, 2.0);
  EXPECT_EQ(instants[1], at(4.0, WandEvent::FallBegins));
  EXPECT_EQ(instants[2].recordingTime, 5.0);
}

} // namespace
} // namespace dewpoint::tests
