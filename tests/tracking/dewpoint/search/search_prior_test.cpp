// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/tracking/dewpoint/search/search_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

const Eigen::Vector3d kStart(1.0, 2.0, 0.5);
const Eigen::Vector3d kFound(3.0, 0.0, 1.0);
constexpr double kRoom = 4.0; ///< meters

/// Standard deviation of 0.1 m: with the 0.1 m that confirmPosition() adds, a variance of 0.02 m².
Gaussian3 found() {
  return {kFound, 0.01 * Eigen::Matrix3d::Identity()};
}

SearchPrior startingIn(double half) {
  SearchPrior prior;
  prior.restart({kStart, Eigen::Vector3d::Constant(half)});
  return prior;
}

double peak(double sigma) {
  return 1.0 / (std::pow(2.0 * std::numbers::pi, 1.5) * sigma * sigma * sigma);
}

// Half of the density is uniform over 64 m³; the other half is a normal one with half the start
// box's half size, 0.25 m, as standard deviation.
TEST(SearchPrior, FavorsTheCenterOfTheStartVolume) {
  const SearchPrior prior = startingIn(0.5);
  const double uniform = 0.5 / 64.0;
  EXPECT_NEAR(prior.birthDensity(kStart, kRoom), 0.5 * peak(0.25) + uniform, 1e-9);
  const Eigen::Vector3d oneSigma = kStart + Eigen::Vector3d(0.25, 0.0, 0.0);
  EXPECT_NEAR(prior.birthDensity(oneSigma, kRoom), 0.5 * peak(0.25) * std::exp(-0.5) + uniform,
              1e-9);
  EXPECT_NEAR(prior.birthDensity(kStart + Eigen::Vector3d(0.0, 100.0, 0.0), kRoom), uniform, 1e-12);
  EXPECT_FALSE(prior.lastPosition());
}

TEST(SearchPrior, LiesAroundTheLastConfirmedPosition) {
  SearchPrior prior = startingIn(0.5);
  prior.confirmPosition(found());
  ASSERT_TRUE(prior.lastPosition());
  EXPECT_EQ(*prior.lastPosition(), kFound);
  EXPECT_NEAR(prior.birthDensity(kFound, kRoom), 0.5 * peak(std::sqrt(0.02)) + 0.5 / 64.0, 1e-9);
  prior.restart({kStart, Eigen::Vector3d::Constant(0.5)});
  EXPECT_FALSE(prior.lastPosition());
}

// By 0.5 m/s: after 0.5 s the standard deviation of 0.141 m is 0.391 m. Beyond 1 m nothing is known
// about the position any more, and it never grows beyond the given bound.
TEST(SearchPrior, WidensWhileNothingIsConfirmed) {
  SearchPrior prior = startingIn(0.5);
  prior.widen(0.5, kRoom); // nothing to widen yet
  EXPECT_NEAR(prior.birthDensity(kStart, kRoom), 0.5 * peak(0.25) + 0.5 / 64.0, 1e-9);
  prior.confirmPosition(found());
  prior.widen(0.5, kRoom);
  const double sigma = std::sqrt(0.02) + 0.25;
  EXPECT_NEAR(prior.birthDensity(kFound, kRoom), 0.5 * peak(sigma) + 0.5 / 64.0, 1e-9);
  EXPECT_TRUE(prior.lastPosition());
  prior.widen(2.0, kRoom);
  EXPECT_FALSE(prior.lastPosition());
  prior.widen(100.0, kRoom);
  EXPECT_NEAR(prior.birthDensity(kFound, kRoom), 0.5 * peak(kRoom) + 0.5 / 64.0, 1e-9);
}

TEST(SearchPrior, HasNoDensityOutsideTheBounds) {
  SearchPrior prior = startingIn(0.5);
  const std::optional<WorldBox> bounds =
      WorldBox{kStart - Eigen::Vector3d::Ones(), kStart + Eigen::Vector3d::Ones()};
  const Eigen::Vector3d beside = kStart + Eigen::Vector3d(1.01, 0.0, 0.0);
  EXPECT_EQ(prior.birthDensity(kStart, kRoom, bounds), prior.birthDensity(kStart, kRoom));
  EXPECT_GT(prior.birthDensity(beside, kRoom), 0.0);
  EXPECT_EQ(prior.birthDensity(beside, kRoom, bounds), 0.0);
  prior.confirmPosition(found());
  EXPECT_EQ(prior.birthDensity(kFound, kRoom, bounds), 0.0);
}

// Means of 20,000 draws: five standard errors of a uniform distribution over 1 m (0.29 m), and of a
// normal one of 0.141 m, are about 0.01 and 0.005 m.
TEST(SearchPrior, DrawsFromTheStartVolumeAndThenAroundThePosition) {
  constexpr Eigen::Index kCount = 20000;
  const RandomStream stream(7, 0, 0, RandomPurpose::Start);
  SearchPrior prior = startingIn(0.5);
  const Eigen::ArrayXXd uniform = prior.drawPositions(kCount, stream);
  ASSERT_EQ(uniform.rows(), kCount);
  ASSERT_EQ(uniform.cols(), 3);
  prior.confirmPosition(found());
  const Eigen::ArrayXXd normal = prior.drawPositions(kCount, stream);
  ASSERT_EQ(normal.rows(), kCount);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_LE((uniform.col(axis) - kStart[axis]).abs().maxCoeff(), 0.5);
    EXPECT_NEAR(uniform.col(axis).mean(), kStart[axis], 0.011);
    EXPECT_NEAR(normal.col(axis).mean(), kFound[axis], 0.005);
    EXPECT_NEAR((normal.col(axis) - kFound[axis]).square().mean(), 0.02, 0.001);
  }
}

} // namespace
} // namespace dewpoint::tests
