// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/crowd_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::CrowdMotion;
using experiment::scenarios::CrowdStart;

constexpr double kCrowdRadius = 0.035;
const Eigen::AlignedBox3d kRoom{Eigen::Vector3d(-1.0, -1.0, -1.0), Eigen::Vector3d(1.0, 1.0, 1.0)};

TEST(CrowdMotion, EqualBallsThatMeetHeadOnChangeTheirSpeeds) {
  const CrowdStart start{{{-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}}, {{0.2, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
  const CrowdMotion motion(start, kRoom, kCrowdRadius, 4.0);
  // They touch after 0.33 m at 0.2 m/s: 1.65 s. One step of 1/240 s at 0.2 m/s is 0.8 mm.
  EXPECT_NEAR(motion.position(0, 1.0).x(), 0.0, 1e-9);
  EXPECT_EQ(motion.position(1, 1.0).x(), 0.2);
  EXPECT_NEAR(motion.position(0, 3.0).x(), 0.13, 0.001) << "it has given its speed away";
  EXPECT_NEAR(motion.position(1, 3.0).x(), 0.2 + 0.2 * (3.0 - 1.65), 0.002);
}

TEST(CrowdMotion, WallsReflect) {
  const CrowdMotion motion({{{0.9, 0.0, 0.0}}, {{0.2, 0.0, 0.0}}}, kRoom, kCrowdRadius, 2.0);
  // The wall for centers is reached after 0.5 s; a second later it is 0.2 m away from it.
  EXPECT_NEAR(motion.position(0, 1.5).x(), 0.8, 0.002);
  EXPECT_EQ(motion.position(0, -1.0).x(), 0.9);
  EXPECT_EQ(motion.position(0, 9.0), motion.position(0, 2.0));
}

TEST(CrowdMotion, BallsTouchAndNeverOverlap) {
  // A lattice of 12 balls in a tight box: they meet all the time.
  const Eigen::AlignedBox3d box{Eigen::Vector3d::Zero(), Eigen::Vector3d(0.3, 0.3, 0.15)};
  CrowdStart start;
  for (int k = 0; k < 12; ++k) {
    start.positions.emplace_back(0.1 * (k % 3), 0.1 * (k / 3 % 2), 0.1 * (k / 6));
    start.velocities.emplace_back(0.2 * std::cos(k), 0.2 * std::sin(k), 0.1 * std::cos(2.0 * k));
  }
  const CrowdMotion motion(start, box, kCrowdRadius, 3.0);
  double nearest = HUGE_VAL;
  int contacts = 0;
  for (int instant = 0; instant <= 720; ++instant) {
    const double time = instant / 240.0;
    for (std::size_t one = 0; one < 12; ++one) {
      const Eigen::Vector3d position = motion.position(one, time);
      EXPECT_TRUE(box.contains(position) || box.exteriorDistance(position) < 1e-3);
      for (std::size_t other = 0; other < one; ++other) {
        const double distance = (position - motion.position(other, time)).norm();
        nearest = std::min(nearest, distance);
        contacts += distance < 2.02 * kCrowdRadius ? 1 : 0;
      }
    }
  }
  EXPECT_GT(nearest, 1.98 * kCrowdRadius);
  EXPECT_GT(contacts, 0);
}

TEST(CrowdMotion, APathKeepsItsMotion) {
  auto motion = std::make_shared<const CrowdMotion>(
      CrowdStart{{{0.0, 0.0, 0.0}}, {{0.1, 0.0, 0.0}}}, kRoom, kCrowdRadius, 1.0);
  const simulation::Path path = pathOf(motion, 0);
  motion.reset();
  EXPECT_NEAR(path(0.5).x(), 0.05, 1e-9);
}

} // namespace
} // namespace dewpoint::tests
