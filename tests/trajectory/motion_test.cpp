// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/motion.h"
#include "core/trajectory/motion_csv.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace dewpoint::tests {
namespace {

constexpr double kPeriod = 1.0 / 30.0;

TrajectorySample sampleAt(std::int64_t frame, const Eigen::Vector3d& place, bool valid = true,
                          const std::string& target = "ball") {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = static_cast<double>(frame) * kPeriod;
  sample.position = place;
  sample.target = target;
  sample.isValid = valid;
  return sample;
}

std::vector<TrajectorySample> straightLine(std::int64_t frames, const Eigen::Vector3d& velocity) {
  std::vector<TrajectorySample> track;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    track.push_back(sampleAt(frame, velocity * (static_cast<double>(frame) * kPeriod)));
  }
  return track;
}

TEST(Motion, aStraightLineHasItsOwnVelocityEverywhere) {
  const Eigen::Vector3d velocity(0.3, -1.2, 0.4); // length 1.3 m/s: 0.09 + 1.44 + 0.16 = 1.69
  const auto track = straightLine(9, velocity);
  for (std::size_t i = 0; i < track.size(); ++i) {
    const auto found = velocityAt(track, i);
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found - velocity).norm(), 0.0, 1e-12);
    EXPECT_NEAR(found->norm(), 1.3, 1e-12);
  }
}

TEST(Motion, theMiddleOfFiveIsTheDerivativeOfSavitzkyAndGolay) {
  // Their first derivative, 5 points, quadratic: (-2 -1 0 1 2) / (10 period).
  const std::array<double, 5> heights{0.1, 0.5, 0.2, 0.9, 0.7};
  std::vector<TrajectorySample> track;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    track.push_back(sampleAt(static_cast<std::int64_t>(i), {0.0, 0.0, heights[i]}));
  }
  const double expected = (-2 * 0.1 - 0.5 + 0.9 + 2 * 0.7) / (10.0 * kPeriod);
  EXPECT_NEAR(velocityAt(track, 2)->z(), expected, 1e-12);
}

TEST(Motion, freeFallIsExactAwayFromTheEnds) {
  // A quadratic's derivative is exact for a symmetric window: v = -g t.
  std::vector<TrajectorySample> track;
  for (std::int64_t frame = 0; frame < 12; ++frame) {
    const double time = static_cast<double>(frame) * kPeriod;
    track.push_back(sampleAt(frame, {0.0, 0.0, 2.0 - 0.5 * 9.81 * time * time}));
  }
  for (std::size_t i = 2; i + 2 < track.size(); ++i) {
    EXPECT_NEAR(velocityAt(track, i)->z(), -9.81 * track[i].time, 1e-10);
  }
}

TEST(Motion, noSpeedAcrossAGapOrWithoutNeighbors) {
  auto track = straightLine(7, {1.0, 0.0, 0.0});
  track[3].isValid = false;
  track[4].position = {50.0, 0.0, 0.0}; // beyond the gap: must not leak into what was before it
  EXPECT_NEAR(velocityAt(track, 2)->x(), 1.0, 1e-12);
  EXPECT_FALSE(velocityAt(track, 3));
  EXPECT_FALSE(velocityAt(std::span(track).first(1), 0));
  track.erase(track.begin() + 3); // now frame 3 is missing instead
  EXPECT_NEAR(velocityAt(track, 2)->x(), 1.0, 1e-12);
}

TEST(MotionLog, speedsOfSamplesThatComeOneByOneAreThoseOfTheWhole) {
  std::vector<TrajectorySample> track;
  for (std::int64_t frame = 0; frame < 40; ++frame) {
    const double angle = 0.2 * static_cast<double>(frame);
    track.push_back(sampleAt(frame, {std::cos(angle), std::sin(angle), 0.1 * angle}, frame != 17));
  }
  MotionLog log;
  for (std::size_t i = 0; i < track.size(); ++i) {
    log.replaceFrom(i, {track[i]});
  }
  ASSERT_EQ(log.rows().size(), track.size());
  for (std::size_t i = 0; i < track.size(); ++i) {
    const auto velocity = velocityAt(track, i);
    EXPECT_EQ(std::isnan(log.rows()[i].speed), !velocity.has_value()) << i;
    if (velocity) {
      EXPECT_DOUBLE_EQ(log.rows()[i].speed, velocity->norm()) << i;
    }
  }
}

TEST(MotionLog, listsGapsWithTheirLength) {
  MotionLog log;
  std::vector<TrajectorySample> samples;
  for (const std::int64_t frame : {0, 1, 2, 3, 4, 8, 9}) {
    samples.push_back(sampleAt(frame, Eigen::Vector3d::Zero(), frame != 2 && frame != 3));
    samples.push_back(sampleAt(frame, Eigen::Vector3d::Zero(), true, "other"));
  }
  samples.back().isValid = false; // the other one is lost at the end
  log.replaceFrom(0, samples);
  const auto gaps = log.gaps();
  ASSERT_EQ(gaps.size(), 4U);
  // Not held at frames 2 and 3: from the last held one (1) to the next (4).
  EXPECT_EQ(gaps[0], (TrajectoryGap{"ball", 2, 3, 1 * kPeriod, 4 * kPeriod}));
  EXPECT_EQ(gaps[0].frameCount(), 2);
  EXPECT_NEAR(gaps[0].durationSeconds(), 3.0 * kPeriod, 1e-12);
  // Frames 5 to 7 are missing for both.
  EXPECT_EQ(gaps[1], (TrajectoryGap{"ball", 5, 7, 4 * kPeriod, 8 * kPeriod}));
  EXPECT_EQ(gaps[2], (TrajectoryGap{"other", 5, 7, 4 * kPeriod, 8 * kPeriod}));
  EXPECT_EQ(gaps[3], (TrajectoryGap{"other", 9, 9, 8 * kPeriod, 9 * kPeriod}));
}

TEST(MotionLog, aFrameThatComesAgainTakesThePlaceOfTheOld) {
  MotionLog log;
  auto track = straightLine(6, {1.0, 0.0, 0.0});
  log.replaceFrom(0, track);
  // The same once more changes nothing.
  EXPECT_EQ(log.replaceFrom(5, {track[5]}).firstChangedRow, 6U);
  track[5].isValid = false;
  const auto change = log.replaceFrom(5, {track[5], sampleAt(6, {0.2, 0.0, 0.0})});
  EXPECT_LE(change.firstChangedRow, 5U);
  ASSERT_EQ(log.rows().size(), 7U);
  EXPECT_TRUE(std::isnan(log.rows()[5].speed));
  EXPECT_NEAR(log.rows()[4].speed, 1.0, 1e-9);
  ASSERT_EQ(log.gaps().size(), 1U);
  EXPECT_EQ(log.gaps()[0].frameCount(), 1);
}

TEST(MotionLog, isBounded) {
  MotionLog log;
  std::size_t dropped = 0;
  constexpr std::size_t kSamples = 2 * MotionLog::kMaxRows;
  constexpr std::size_t kPiece = 1000;
  for (std::size_t first = 0; first < kSamples; first += kPiece) {
    std::vector<TrajectorySample> piece;
    for (std::size_t i = 0; i < kPiece; ++i) {
      piece.push_back(sampleAt(static_cast<std::int64_t>(first + i), Eigen::Vector3d::Zero()));
    }
    dropped += log.replaceFrom(first, piece).droppedRowCount;
    ASSERT_LE(log.rows().size(), MotionLog::kMaxRows + kPiece);
  }
  EXPECT_EQ(dropped + log.rows().size(), kSamples);
  EXPECT_EQ(log.rows().back().sample.frame, static_cast<std::int64_t>(kSamples - 1));
  // A new run begins at 0 and is all there is.
  log.replaceFrom(0, {sampleAt(0, Eigen::Vector3d::Zero()), sampleAt(1, Eigen::Vector3d::Zero())});
  EXPECT_EQ(log.rows().size(), 2U);
}

TEST(Motion, aTableIsReadAnywhere) {
  MotionLog::Row row{sampleAt(3, {1.5, -0.25, 0.0}, true, "ball, red"), 1.25};
  row.sample.time = 0.1;
  row.sample.covariance = Eigen::Vector3d(4e-6, 1e-6, -1e-20).asDiagonal();
  row.sample.cameraCount = 2;
  row.sample.existenceProbability = 0.5;
  MotionLog::Row unknown = row;
  unknown.sample.target = "ball";
  unknown.speed = std::numeric_limits<double>::quiet_NaN();
  unknown.sample.isValid = false;
  EXPECT_EQ(motionCsv(std::array{row, unknown}),
            "time_s,frame,target,x_m,y_m,z_m,sigma_x_m,sigma_y_m,sigma_z_m,speed_m_s,cameras,"
            "existence,valid\n"
            "0.1,3,\"ball, red\",1.5,-0.25,0,0.002,0.001,0,1.25,2,0.5,1\n"
            "0.1,3,ball,1.5,-0.25,0,0.002,0.001,0,,2,0.5,0\n");
}

TEST(Motion, aLineEndsWhereMoreFramesAreMissingThanCamerasSkip) {
  EXPECT_FALSE(isTrackInterrupted(10, 11));
  EXPECT_FALSE(isTrackInterrupted(10, 18));
  EXPECT_TRUE(isTrackInterrupted(10, 19));
}

} // namespace
} // namespace dewpoint::tests
