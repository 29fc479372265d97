// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/tracking/people/people_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

/// Points spread normally with 0.2 m along each axis around (1, 2, 0.9).
BodyCloud normalCloud(Eigen::Index count) {
  const RandomStream stream(7, 0, 0, RandomPurpose::Start);
  BodyCloud cloud{Eigen::ArrayXXd(count, 3), Eigen::ArrayXd::Constant(count, 1.0 / count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto normal = stream.normal4(static_cast<std::uint32_t>(i));
    cloud.points.row(i) << 1.0 + 0.2 * normal[0], 2.0 + 0.2 * normal[1], 0.9 + 0.2 * normal[2];
  }
  return cloud;
}

TEST(BodyHull, HoldsTheShareItSays) {
  const BodyCloud cloud = normalCloud(2000);
  // 95 % of a three-dimensional normal distribution lie within 2.795 sigma (chi-square, 3 degrees
  // of freedom: 7.815). The hull of points inside stays a little within that ball.
  const double radius = 2.795 * 0.2;
  const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3.0);
  const ConvexHull hull = bodyHull(cloud, 0.95, 0.05);
  EXPECT_GT(hull.volume(), 0.7 * ball);
  EXPECT_LT(hull.volume(), 1.1 * ball);
  EXPECT_LT(bodyHull(cloud, 0.5, 0.05).volume(), 0.5 * hull.volume());
  EXPECT_TRUE(bodyHull({}).empty());
}

TEST(DensityAtPoints, IsThatOfItsKernels) {
  BodyCloud two{Eigen::ArrayXXd::Zero(2, 3), Eigen::ArrayXd::Constant(2, 0.5)};
  two.points(1, 0) = 0.1; // one sigma away
  const double peak = std::pow(2.0 * std::numbers::pi * 0.01, -1.5);
  EXPECT_NEAR(densityAtPoints(two, 0.1)[0], peak * 0.5 * (1.0 + std::exp(-0.5)), 1e-9);
}

TEST(GroundDensity, IntegratesToOne) {
  const GroundGrid grid = groundDensity(normalCloud(500), 0.05, 0.08);
  EXPECT_NEAR(grid.values.sum() * grid.step * grid.step, 1.0, 0.01);
  Eigen::Index i = 0;
  Eigen::Index j = 0;
  grid.values.maxCoeff(&i, &j);
  const Eigen::Vector2d top = grid.origin + grid.step * Eigen::Vector2d(i, j);
  EXPECT_LT((top - Eigen::Vector2d(1.0, 2.0)).norm(), 0.15);
  EXPECT_EQ(groundDensity({}).values.size(), 0);
}

} // namespace
} // namespace dewpoint::tests
