// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/piecewise_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::Bounce;
using experiment::scenarios::PiecewisePath;

constexpr double kClose = 1e-9;

/// By central differences over 0.2 ms.
Eigen::Vector3d velocityAt(const PiecewisePath& path, double time) {
  return (path(time + 1e-4) - path(time - 1e-4)) / 2e-4;
}

TEST(PiecewisePath, FallsByHalfOfGravityTimesTheSquareOfTheTime) {
  PiecewisePath path({1.0, 2.0, 3.0});
  path.rest(0.5);
  path.accelerate(experiment::scenarios::kGravity, 0.4);
  EXPECT_LT((path(-1.0) - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), kClose);
  EXPECT_LT((path(0.3) - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), kClose);
  EXPECT_NEAR(path(0.7).z(), 3.0 - 0.5 * 9.81 * 0.04, kClose);
  EXPECT_NEAR(path(5.0).z(), 3.0 - 0.5 * 9.81 * 0.16, kClose) << "it stays where it ended";
  EXPECT_NEAR(path.endTime(), 0.9, kClose);
  EXPECT_NEAR(path.velocity().z(), -9.81 * 0.4, kClose);
}

TEST(PiecewisePath, AThrowIsABallisticArcFromRestToRest) {
  const Eigen::Vector3d from{0.1, 0.0, 0.2};
  const Eigen::Vector3d to{0.3, 0.1, 0.15};
  PiecewisePath path(from);
  path.rest(0.2);
  addThrow(path, to, 0.3);
  EXPECT_LT((path.position() - to).norm(), kClose);
  EXPECT_LT(path.velocity().norm(), kClose);
  // A swing of 0.06 s, the flight, and a swing.
  EXPECT_NEAR(path.endTime(), 0.2 + 0.06 + 0.3 + 0.06, kClose);
  for (const double time : {0.28, 0.41, 0.54}) { // in flight
    const Eigen::Vector3d acceleration =
        (path(time + 0.01) - 2.0 * path(time) + path(time - 0.01)) / 1e-4;
    EXPECT_LT((acceleration - Eigen::Vector3d(0.0, 0.0, -9.81)).norm(), 1e-6);
  }
  // No jump of position or speed where the pieces meet.
  for (const double time : {0.2, 0.26, 0.56, 0.62}) {
    EXPECT_LT((path(time + 1e-6) - path(time - 1e-6)).norm(), 1e-5);
    EXPECT_LT((velocityAt(path, time + 2e-4) - velocityAt(path, time - 2e-4)).norm(), 0.05);
  }
}

TEST(PiecewisePath, ACarryIsFastestInTheMiddle) {
  PiecewisePath path(Eigen::Vector3d::Zero());
  addCarry(path, {0.2, 0.0, 0.0}, 0.5);
  EXPECT_NEAR(path.position().x(), 0.2, kClose);
  EXPECT_LT(path.velocity().norm(), kClose);
  EXPECT_NEAR(path(0.25).x(), 0.1, kClose);
  EXPECT_NEAR(velocityAt(path, 0.25).x(), 0.8, 1e-3) << "twice the mean speed";
}

TEST(PiecewisePath, BouncesLoseTheirShareOfTheSpeed) {
  constexpr double kFloor = 0.035;
  PiecewisePath path({0.0, 0.0, kFloor + 0.1});
  path.setVelocity({0.1, 0.0, 0.0});
  addBounces(path, Bounce{kFloor, 0.7, 0.9});
  const double fall = std::sqrt(2.0 * 0.1 / 9.81);
  EXPECT_NEAR(path(fall).z(), kFloor, kClose);
  const double speed = 9.81 * fall;
  EXPECT_NEAR(velocityAt(path, fall + 2e-4).z(), 0.7 * speed, 0.01);
  EXPECT_NEAR(velocityAt(path, fall + 2e-4).x(), 0.09, 1e-6);
  // It rises to 0.49 of the height.
  EXPECT_NEAR(path(fall + 0.7 * fall).z(), kFloor + 0.049, 1e-6);
  double lowest = HUGE_VAL;
  for (double time = 0.0; time < path.endTime(); time += 0.001) {
    lowest = std::min(lowest, path(time).z());
  }
  EXPECT_GT(lowest, kFloor - kClose);
  EXPECT_NEAR(path.position().z(), kFloor, kClose);
  EXPECT_EQ(path.velocity().norm(), 0.0);
  // Speeds 1.40, 0.98, 0.69, 0.48, 0.34, 0.24, 0.165 m/s; 0.115 is below a millimeter's. Between
  // two contacts it flies for twice the speed over gravity.
  EXPECT_NEAR(path.endTime(),
              fall + 2.0 / 9.81 * speed * (0.7 + 0.49 + 0.343 + 0.2401 + 0.16807 + 0.117649), 1e-9);
}

} // namespace
} // namespace dewpoint::tests
