// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/filter/gaussian.h"
#include "core/filter/prepared_gaussian.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

using Matrix6 = Gaussian6::Matrix;
using Vector6 = Gaussian6::Vector;

void expectNear(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double tolerance) {
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), tolerance) << actual << "\n\n" << expected;
}

// One axis by hand. Prior: place variance 4, covariance 2, velocity variance 3. A measurement of
// variance 4, two meters ahead: gain 4 / (4 + 4) = 1/2 for the place, 2 / 8 = 1/4 for the velocity.
// Posterior: the place moves by 1, the velocity by 0.5; variances 4 - 16/8 = 2, 2 - 8/8 = 1 and
// 3 - 4/8 = 2.5.
TEST(Condition, IsTheKalmanUpdateByHand) {
  Gaussian6 belief;
  belief.mean << 1.0, 2.0, 3.0, 0.1, 0.2, 0.3;
  belief.covariance.setZero();
  for (int axis = 0; axis < 3; ++axis) {
    belief.covariance(axis, axis) = 4.0;
    belief.covariance(axis, axis + 3) = belief.covariance(axis + 3, axis) = 2.0;
    belief.covariance(axis + 3, axis + 3) = 3.0;
  }
  Gaussian3 place;
  place.mean = Eigen::Vector3d(2.0, 3.0, 4.0);
  place.covariance = 2.0 * Eigen::Matrix3d::Identity();
  conditionOnPosition(belief, place);
  Vector6 mean;
  mean << 2.0, 3.0, 4.0, 0.6, 0.7, 0.8;
  Matrix6 covariance = Matrix6::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    covariance(axis, axis) = 2.0;
    covariance(axis, axis + 3) = covariance(axis + 3, axis) = 1.0;
    covariance(axis + 3, axis + 3) = 2.5;
  }
  expectNear(belief.mean, mean, 1e-12);
  expectNear(belief.covariance, covariance, 1e-12);
}

/// A covariance whose axes are all coupled.
Matrix6 coupledCovariance() {
  Matrix6 root;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      root(row, column) = std::sin(1.0 + 3.0 * row + 7.0 * column + row * column);
    }
  }
  return root * root.transpose() + 0.1 * Matrix6::Identity();
}

// The textbook update (H = [I 0], K = P H' (H P H' + R)^-1) of a state whose axes are all coupled.
TEST(Condition, IsTheKalmanUpdateOfACoupledState) {
  Gaussian6 belief;
  belief.mean << 0.3, -0.2, 0.9, 1.0, -2.0, 0.5;
  belief.covariance = coupledCovariance();
  const Eigen::Vector3d measured(0.5, 0.1, 0.4);
  Eigen::Matrix3d noise;
  noise << 0.5, 0.1, 0.0, 0.1, 0.3, -0.05, 0.0, -0.05, 0.2;
  const Eigen::Matrix3d innovation = belief.covariance.topLeftCorner<3, 3>() + noise;
  const Eigen::Matrix<double, 6, 3> gain =
      belief.covariance.leftCols<3>() * innovation.inverse().eval();
  const Vector6 mean = belief.mean + gain * (measured - belief.mean.head<3>());
  const Matrix6 covariance = belief.covariance - gain * innovation * gain.transpose();

  conditionOnPosition(belief, {mean.head<3>(), covariance.topLeftCorner<3, 3>()});
  expectNear(belief.mean, mean, 1e-10);
  expectNear(belief.covariance, covariance, 1e-10);
}

TEST(Condition, OnWhatIsBelievedAlreadyChangesNothing) {
  Gaussian6 belief;
  belief.mean << 0.3, -0.2, 0.9, 1.0, -2.0, 0.5;
  belief.covariance = coupledCovariance();
  const Gaussian6 before = belief;
  conditionOnPosition(belief, {before.mean.head<3>(), before.covariance.topLeftCorner<3, 3>()});
  expectNear(belief.mean, before.mean, 1e-12);
  expectNear(belief.covariance, before.covariance, 1e-12);
}

// Variances 1, 4 and 9: the peak of the density is 1 / ((2 pi)^1.5 * 6); a point one standard
// deviation off along each axis has the squared distance 3.
TEST(PreparedGaussian3, DensityByHand) {
  Gaussian3 gaussian;
  gaussian.mean = Eigen::Vector3d(1.0, 2.0, 3.0);
  gaussian.covariance = Eigen::Vector3d(1.0, 4.0, 9.0).asDiagonal();
  const PreparedGaussian3 prepared(gaussian);
  const double peak = -1.5 * std::log(2.0 * std::numbers::pi) - std::log(6.0);
  EXPECT_NEAR(prepared.logDensity(gaussian.mean), peak, 1e-12);
  EXPECT_NEAR(prepared.squaredDistance({2.0, 4.0, 0.0}), 3.0, 1e-12);
  EXPECT_NEAR(prepared.logDensity({2.0, 4.0, 0.0}), peak - 1.5, 1e-12);
}

TEST(PreparedGaussian3, DistanceIsTheMahalanobisDistance) {
  Gaussian3 gaussian;
  gaussian.mean = Eigen::Vector3d(-0.5, 0.25, 2.0);
  gaussian.covariance = coupledCovariance().topLeftCorner<3, 3>();
  const PreparedGaussian3 prepared(gaussian);
  const Eigen::Vector3d place(0.1, 0.9, 1.5);
  const Eigen::Vector3d off = place - gaussian.mean;
  EXPECT_NEAR(prepared.squaredDistance(place), off.dot(gaussian.covariance.inverse() * off), 1e-9);
}

// Moments of 10^5 draws; five standard errors: of a mean sqrt(variance / n), of a covariance at
// most sqrt(2 / n) times the largest variance.
TEST(PreparedGaussian3, PlacesHaveTheMomentsOfTheGaussian) {
  Gaussian3 gaussian;
  gaussian.mean = Eigen::Vector3d(1.0, -2.0, 0.5);
  gaussian.covariance = coupledCovariance().topLeftCorner<3, 3>();
  const PreparedGaussian3 prepared(gaussian);
  constexpr int kDraws = 100000;
  const RandomStream stream(3, 0, 0, RandomPurpose::Proposal);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto normal = stream.normal4(i);
    const Eigen::Vector3d off =
        prepared.fromStandardNormal({normal[0], normal[1], normal[2]}) - gaussian.mean;
    sum += off;
    products += off * off.transpose();
  }
  const double largest = gaussian.covariance.diagonal().maxCoeff();
  expectNear(sum / kDraws, Eigen::Vector3d::Zero(), 5.0 * std::sqrt(largest / kDraws));
  expectNear(products / kDraws, gaussian.covariance, 5.0 * largest * std::sqrt(2.0 / kDraws));
}

} // namespace
} // namespace dewpoint::tests
