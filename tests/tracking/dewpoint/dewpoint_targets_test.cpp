// SPDX-License-Identifier: GPL-3.0-or-later
// Method `dewpoint` with several targets.
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <functional>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;
using drawn::redBall;
using drawn::rigAround;

using Paths = std::function<std::vector<Ball>(int frame)>;

double distanceTo(const SphereEstimate& estimate, const Ball& ball) {
  return (estimate.mean - ball.center).norm();
}

/// Which of two balls target 0 is on after `settled` frames; then both stay on theirs to the end.
void expectIdentitiesKept(const CameraRig& rig, const Paths& paths, int settled, int frames,
                          double tolerance) {
  DrawnRun run(rig, {redBall(), redBall()});
  std::size_t first = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const std::vector<Ball> balls = paths(frame);
    run.show(balls);
    if (frame + 1 < settled) {
      continue;
    }
    if (frame + 1 == settled) {
      first = distanceTo(run.estimate(0), balls[0]) < distanceTo(run.estimate(0), balls[1]) ? 0 : 1;
    }
    EXPECT_LT(distanceTo(run.estimate(0), balls[first]), tolerance) << frame;
    EXPECT_LT(distanceTo(run.estimate(1), balls[1 - first]), tolerance) << frame;
    EXPECT_TRUE(run.estimate(0).isValid && run.estimate(1).isValid) << frame;
  }
}

// Straight past each other at 0.6 m/s each, 9 cm apart at the closest: 2 cm between them.
TEST(DewpointTargets, TwoIdenticalOnesKeepTheirIdentitiesWhilePassing) {
  const Paths paths = [](int frame) {
    const double along = 0.2 - 0.01 * frame;
    return std::vector<Ball>{Ball{drawn::kMiddle + Eigen::Vector3d(along, 0.045, 0.0)},
                             Ball{drawn::kMiddle + Eigen::Vector3d(-along, -0.045, 0.0)}};
  };
  expectIdentitiesKept(rigAround(3), paths, 5, 40, 12e-3);
}

// The same with the second 12 cm above: in every camera one hides the other or nearly so.
TEST(DewpointTargets, TwoIdenticalOnesCrossAtRightAngles) {
  const Paths paths = [](int frame) {
    const double along = 0.2 - 0.01 * frame;
    return std::vector<Ball>{Ball{drawn::kMiddle + Eigen::Vector3d(along, 0.0, -0.06)},
                             Ball{drawn::kMiddle + Eigen::Vector3d(0.0, along, 0.06)}};
  };
  expectIdentitiesKept(rigAround(3), paths, 5, 40, 12e-3);
}

TEST(DewpointTargets, NeverTwoOnOneBall) {
  DrawnRun run(rigAround(2), {redBall(), redBall()});
  for (int frame = 0; frame < 30; ++frame) {
    run.show({Ball{drawn::kMiddle}});
    if (frame >= 3) {
      EXPECT_NE(run.estimate(0).isValid, run.estimate(1).isValid) << frame;
      const SphereEstimate& seen = run.estimate(run.estimate(0).isValid ? 0 : 1);
      EXPECT_LT((seen.mean - drawn::kMiddle).norm(), 3e-3) << frame;
    }
  }
}

TEST(DewpointTargets, EachColorItsOwn) {
  Target blue = redBall(0.03);
  blue.color.hueMin = 220.0;
  blue.color.hueMax = 260.0;
  DrawnRun run(rigAround(2), {redBall(), blue});
  const Ball red{drawn::kMiddle + Eigen::Vector3d(0.05, 0.0, 0.0)};
  const Ball other{drawn::kMiddle + Eigen::Vector3d(-0.05, 0.0, 0.0), 0.03, {230, 0, 0}};
  for (int frame = 0; frame < 5; ++frame) {
    run.show({red, other});
  }
  EXPECT_TRUE(run.estimate(0).isValid);
  EXPECT_LT(distanceTo(run.estimate(0), red), 4e-3);
  EXPECT_TRUE(run.estimate(1).isValid);
  EXPECT_LT(distanceTo(run.estimate(1), other), 4e-3);
  // One vanishes, the other stays.
  for (int frame = 0; frame < 3; ++frame) {
    run.show({red});
  }
  EXPECT_TRUE(run.estimate(0).isValid);
  EXPECT_FALSE(run.estimate(1).isValid);
}

TEST(DewpointTargets, FiveIdenticalOnesAreAllFound) {
  DrawnRun run(rigAround(3), std::vector<Target>(5, redBall()));
  std::vector<Ball> balls;
  for (int k = 0; k < 5; ++k) {
    balls.push_back(Ball{drawn::kMiddle + Eigen::Vector3d(-0.2 + 0.1 * k, 0.08 * (k % 2), 0.0)});
  }
  for (int frame = 0; frame < 15; ++frame) {
    run.show(balls);
  }
  for (const Ball& ball : balls) {
    int on = 0;
    for (std::size_t target = 0; target < 5; ++target) {
      on += run.estimate(target).isValid && distanceTo(run.estimate(target), ball) < 5e-3 ? 1 : 0;
    }
    EXPECT_EQ(on, 1) << ball.center.transpose();
  }
}

} // namespace
} // namespace dewpoint::tests
