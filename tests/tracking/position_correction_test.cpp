// SPDX-License-Identifier: GPL-3.0-or-later
// What the methods for colored spheres make of a position that the user gave.
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <string>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;
using drawn::kClose;
using drawn::redBall;
using drawn::rigAround;

const Eigen::Vector3d kLeft = drawn::kMiddle + Eigen::Vector3d(-0.1, 0.1, 0.0);
const Eigen::Vector3d kRight = drawn::kMiddle + Eigen::Vector3d(0.1, -0.1, 0.0);

Gaussian3 around(const Eigen::Vector3d& position, double sigma = 0.01) {
  return {position, sigma * sigma * Eigen::Matrix3d::Identity()};
}

/// One target, which is on the left of two equal balls after 8 frames: the right one came later.
class LeftRun : public DrawnRun {
public:
  explicit LeftRun(double radius = 0.035) : DrawnRun(rigAround(2), {redBall(radius)}) {
    show({Ball{kLeft}});
    show({Ball{kLeft}});
    for (int frame = 2; frame < 8; ++frame) {
      show({Ball{kLeft}, Ball{kRight}});
    }
    EXPECT_LT((estimate().mean - kLeft).norm(), 2.0 * kClose);
  }
  void correct(const Gaussian3& position) { tracker().correctPosition(0, position, team_); }

private:
  ThreadTeam team_{1};
};

class CorrectedPosition : public ::testing::TestWithParam<const char*> {
protected:
  std::unique_ptr<Tracker> tracked(int frames) {
    auto tracker = makeTracker(GetParam(), drawn::parametersOf(GetParam()), rig_, {redBall()});
    EXPECT_TRUE(tracker);
    (*tracker)->restart(5);
    for (int frame = 0; frame < frames; ++frame) {
      show(**tracker, frame);
    }
    return std::move(*tracker);
  }
  void show(Tracker& tracker, int frame) {
    tracker.beginFrame(drawn::framesOf(rig_, {Ball{kLeft}}, frame));
    for (int k = 0; k < tracker.iterationsPerFrame(); ++k) {
      tracker.iterate(team_);
    }
  }
  void correct(Tracker& tracker, const Gaussian3& position) {
    auto* const correcting = capability<PositionCorrecting>(tracker);
    ASSERT_NE(correcting, nullptr);
    correcting->correctPosition(0, position, team_);
  }

  CameraRig rig_ = rigAround(2);
  ThreadTeam team_{1};
};

TEST_P(CorrectedPosition, HoldsAtOnce) {
  const auto tracker = tracked(3);
  correct(*tracker, around(kLeft, 0.005));
  const SphereEstimate estimate = sphereOf(*tracker);
  EXPECT_LT((estimate.mean - kLeft).norm(), 0.005);
  EXPECT_LE(estimate.covariance.trace(), 3.0 * 0.005 * 0.005 + 1e-12);
  EXPECT_TRUE(estimate.isValid);
  EXPECT_GT(estimate.existenceProbability, 0.9);
  EXPECT_EQ(estimate.seeingCameraCount, 2);
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  capability<ParticleCloud>(*tracker)->copyParticles(0, 1000, positions, weights);
  ASSERT_GT(positions.rows(), 0);
  for (int axis = 0; axis < 3; ++axis) { // within five standard deviations, and what proposals add
    EXPECT_LT((positions.col(axis) - kLeft[axis]).abs().maxCoeff(), 0.05) << axis;
  }
}

// What a copy is made of goes through a correction with the same bits, on any number of threads.
TEST_P(CorrectedPosition, GivesTheSameBitsToACopy) {
  const auto straight = tracked(4);
  const auto copy = capability<Copyable>(*tracked(3))->clone();
  show(*copy, 3);
  correct(*straight, around(kLeft + Eigen::Vector3d(0.01, 0.0, 0.0)));
  auto* const correcting = capability<PositionCorrecting>(*copy);
  ThreadTeam three(3);
  correcting->correctPosition(0, around(kLeft + Eigen::Vector3d(0.01, 0.0, 0.0)), three);
  EXPECT_EQ(sphereOf(*straight).mean, sphereOf(*copy).mean);
  for (int frame = 4; frame < 8; ++frame) {
    show(*straight, frame);
    show(*copy, frame);
    ASSERT_EQ(sphereOf(*straight).mean, sphereOf(*copy).mean) << frame;
    ASSERT_EQ(sphereOf(*straight).covariance, sphereOf(*copy).covariance) << frame;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, CorrectedPosition,
                         testing::Values("dewpoint", "barrera", "dynamics"));

TEST(CorrectedDewpoint, GoesOnFromThereAndLeavesTheOther) {
  LeftRun run;
  run.correct(around(kRight + Eigen::Vector3d(0.008, -0.006, 0.0)));
  // The images of the frame make a rough click precise.
  EXPECT_LT((run.estimate().mean - kRight).norm(), kClose);
  EXPECT_TRUE(run.estimate().isValid);
  for (int frame = 0; frame < 30; ++frame) {
    const Eigen::Vector3d moved = kRight + Eigen::Vector3d(0.0, 0.003 * frame, 0.0);
    const SphereEstimate estimate = run.show({Ball{kLeft}, Ball{moved}});
    EXPECT_LT((estimate.mean - moved).norm(), 2.0 * kClose) << frame;
    EXPECT_TRUE(estimate.isValid) << frame;
  }
}

// What was given by hand is free of the calibration's error, but for its frame alone.
TEST(CorrectedDewpoint, StatesTheErrorsOfTheImagesAgainFromTheNextFrame) {
  LeftRun run;
  const double before = run.estimate().covariance.trace();
  run.correct(around(kLeft, 0.001));
  EXPECT_LE(run.estimate().covariance.trace(), 3.0 * 0.001 * 0.001 + 1e-12);
  for (int frame = 0; frame < 3; ++frame) {
    run.show({Ball{kLeft}, Ball{kRight}});
  }
  EXPECT_GT(run.estimate().covariance.trace(), 0.9 * before);
}

// A click in one camera leaves the depth open: 0.15 m along the ray, 0.007 m across.
TEST(CorrectedDewpoint, FindsTheTargetAlongTheRayOfOneClick) {
  LeftRun run;
  const Eigen::Vector3d ray = (kRight - run.rig()[0].center()).normalized();
  Gaussian3 onTheRay = around(kRight + 0.12 * ray, 0.007);
  onTheRay.covariance += 0.15 * 0.15 * ray * ray.transpose();
  run.correct(onTheRay);
  EXPECT_LT((run.estimate().mean - kRight).norm(), 0.01);
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.show({Ball{kLeft}, Ball{kRight}}).mean - kRight).norm(), kClose);
}

TEST(CorrectedDewpoint, KeepsARadiusThatWasEstimated) {
  LeftRun run(0.0);
  const double before = run.estimate().radius;
  EXPECT_NEAR(before, 0.035, 0.003);
  // Where no ball is: nothing measures it again.
  run.correct(around(drawn::kMiddle));
  EXPECT_EQ(run.estimate().radius, before);
  EXPECT_LT((run.estimate().mean - drawn::kMiddle).norm(), 0.03);
}

// An iteration more on the same frame measures from the correction, not from what was before.
TEST(CorrectedDewpoint, IsNotForgottenByAnotherIteration) {
  LeftRun run;
  run.correct(around(kRight));
  EXPECT_LT((run.again().mean - kRight).norm(), kClose);
}

// The other target gives way, and finds the ball that is left.
TEST(CorrectedDewpoint, ExchangesTargetsThatWereConfused) {
  DrawnRun run(rigAround(3), {redBall(), redBall()});
  const std::vector<Ball> balls{Ball{kLeft}, Ball{kRight}};
  for (int frame = 0; frame < 8; ++frame) {
    run.show(balls);
  }
  ASSERT_TRUE(run.estimate(0).isValid && run.estimate(1).isValid);
  const Eigen::Vector3d first = run.estimate(0).mean;
  const Eigen::Vector3d second = run.estimate(1).mean;
  ASSERT_GT((first - second).norm(), 0.2);
  ThreadTeam team(1);
  run.tracker().correctPosition(0, around(second), team);
  EXPECT_LT((run.estimate(0).mean - second).norm(), kClose);
  EXPECT_FALSE(run.estimate(1).isValid);
  for (int frame = 0; frame < 10; ++frame) {
    run.show(balls);
    EXPECT_LT((run.estimate(0).mean - second).norm(), 2.0 * kClose) << frame;
  }
  EXPECT_LT((run.estimate(1).mean - first).norm(), 2.0 * kClose);
}

} // namespace
} // namespace dewpoint::tests
