// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/constant_velocity.h"
#include "core/filter/models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

static_assert(MotionModel<ConstantVelocity>);

// From a known state, after 0.5 s with accelerations of 2 m/s²: the place by 0.5 v, and the
// covariance (t^4/4, t^3/2, t^2) * 4 = (0.0625, 0.25, 1): Bar-Shalom et al. 2001, section 6.3.2.
TEST(ConstantVelocity, GaussianByHand) {
  Gaussian6 belief;
  belief.mean << 1.0, 2.0, 3.0, 0.5, -1.0, 2.0;
  belief.covariance.setZero();
  ConstantVelocity{0.5, 2.0}.predict(belief);
  Gaussian6::Vector mean;
  mean << 1.25, 1.5, 4.0, 0.5, -1.0, 2.0;
  EXPECT_LT((belief.mean - mean).cwiseAbs().maxCoeff(), 1e-12);
  Gaussian6::Matrix covariance = Gaussian6::Matrix::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    covariance(axis, axis) = 0.0625;
    covariance(axis, axis + 3) = covariance(axis + 3, axis) = 0.25;
    covariance(axis + 3, axis + 3) = 1.0;
  }
  EXPECT_LT((belief.covariance - covariance).cwiseAbs().maxCoeff(), 1e-12);
}

// A velocity known to 0.3 m/s makes the place uncertain by 0.3 t.
TEST(ConstantVelocity, UncertainVelocitySpreadsThePlace) {
  Gaussian6 belief;
  belief.covariance.setZero();
  belief.covariance(3, 3) = 0.09;
  ConstantVelocity{2.0, 0.0}.predict(belief);
  EXPECT_NEAR(belief.covariance(0, 0), 0.36, 1e-12);
  EXPECT_NEAR(belief.covariance(0, 3), 0.18, 1e-12);
  EXPECT_NEAR(belief.covariance(3, 3), 0.09, 1e-12);
  EXPECT_EQ(belief.covariance(1, 1), 0.0);
}

/// Particles with independent places (standard deviation 0.1 m) and velocities (0.5 m/s) about
/// (1, 2, 3) and (1, 0, -1).
Eigen::ArrayXXd particles(Eigen::Index count) {
  const RandomStream stream(21, 0, 0, RandomPurpose::Start);
  Eigen::ArrayXXd states(count, 6);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto a = stream.normal4(static_cast<std::uint32_t>(i), 0);
    const auto b = stream.normal4(static_cast<std::uint32_t>(i), 1);
    states.row(i) << 1.0 + 0.1 * a[0], 2.0 + 0.1 * a[1], 3.0 + 0.1 * a[2], 1.0 + 0.5 * b[0],
        0.5 * b[1], -1.0 + 0.5 * b[2];
  }
  return states;
}

// The moments of 10^5 particles against predict() of the Gaussian they were drawn from, within
// five standard errors (mean: sqrt(variance / n); covariance: at most sqrt(2 v w / n)).
TEST(ConstantVelocity, ParticlesHaveTheMomentsOfTheGaussian) {
  constexpr Eigen::Index kCount = 100000;
  const ConstantVelocity motion{0.2, 3.0};
  Eigen::ArrayXXd states = particles(kCount);
  motion.predict(states, 0, RandomStream(4, 1, 0, RandomPurpose::Motion));
  Gaussian6 belief;
  belief.mean << 1.0, 2.0, 3.0, 1.0, 0.0, -1.0;
  belief.covariance.setZero();
  belief.covariance.diagonal() << 0.01, 0.01, 0.01, 0.25, 0.25, 0.25;
  motion.predict(belief);
  const Eigen::RowVectorXd mean = states.matrix().colwise().mean();
  const Eigen::MatrixXd off = states.matrix().rowwise() - mean;
  const Eigen::MatrixXd covariance = off.transpose() * off / double(kCount);
  for (int row = 0; row < 6; ++row) {
    const double variance = belief.covariance(row, row);
    EXPECT_NEAR(mean[row], belief.mean[row], 5.0 * std::sqrt(variance / kCount)) << row;
    for (int column = 0; column < 6; ++column) {
      const double error = std::sqrt(2.0 * variance * belief.covariance(column, column) / kCount);
      EXPECT_NEAR(covariance(row, column), belief.covariance(row, column), 5.0 * error)
          << row << ", " << column;
    }
  }
}

TEST(ConstantVelocity, DoesNotDependOnHowTheSetIsCut) {
  const ConstantVelocity motion{0.1, 5.0};
  const RandomStream stream(8, 2, 1, RandomPurpose::Motion);
  Eigen::ArrayXXd whole = particles(100);
  Eigen::ArrayXXd parts = whole;
  motion.predict(whole, 7, stream);
  motion.predict(parts.topRows(33), 7, stream);
  motion.predict(parts.bottomRows(67), 7 + 33, stream);
  EXPECT_TRUE((whole == parts).all());
}

TEST(ConstantVelocity, NothingMovesWithoutTime) {
  Eigen::ArrayXXd states = particles(10);
  const Eigen::ArrayXXd before = states;
  const ConstantVelocity still{0.0, 8.0};
  still.predict(states, 0, RandomStream(1, 1, 1, RandomPurpose::Motion));
  EXPECT_TRUE((states == before).all());
}

} // namespace
} // namespace dewpoint::tests
