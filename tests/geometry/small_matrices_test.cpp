// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/small_matrices.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(SmallMatrices, SmallSymmetricMatricesHaveTheirEigenvaluesInRisingOrder) {
  // By hand: (1, -1) and (1, 1) are the eigenvectors of [2 1; 1 2].
  const Eigen::Matrix2d two = Eigen::Vector4d(2.0, 1.0, 1.0, 2.0).reshaped(2, 2);
  const auto ofTwo = geometry::symmetricEigen2(two);
  EXPECT_NEAR(ofTwo.values[0], 1.0, 1e-14);
  EXPECT_NEAR(ofTwo.values[1], 3.0, 1e-14);
  EXPECT_NEAR(std::abs(ofTwo.vectors.col(1).dot(Eigen::Vector2d(1.0, 1.0))), std::sqrt(2.0), 1e-14);

  const Eigen::Matrix3d three = Eigen::Vector3d(5.0, -1.0, 2.0).asDiagonal();
  const auto ofThree = geometry::symmetricEigen3(three);
  EXPECT_LT((ofThree.values - Eigen::Vector3d(-1.0, 2.0, 5.0)).norm(), 1e-14);
  EXPECT_LT((ofThree.vectors.cwiseAbs().col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-14);
}

TEST(SmallMatrices, ARotationThatWasStretchedIsTheNearestOrthogonalMatrix) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0).toRotationMatrix();
  // R S with S symmetric and positive definite: its polar decomposition has the rotation R.
  Eigen::Matrix3d stretch;
  stretch << 1.01, 0.02, 0.0, 0.02, 0.98, 0.01, 0.0, 0.01, 1.0;
  EXPECT_LT((geometry::nearestOrthogonal(rotation * stretch) - rotation).norm(), 1e-13);
}

TEST(SmallMatrices, ASimilarityIsFoundFromPointsItMoved) {
  const std::vector<Eigen::Vector3d> from{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}};
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).matrix();
  const Eigen::Vector3d shift(0.5, -1.0, 2.0);
  for (const double scale : {1.0, 2.5}) {
    std::vector<Eigen::Vector3d> to;
    for (const Eigen::Vector3d& point : from) {
      to.emplace_back(scale * (rotation * point) + shift);
    }
    const Eigen::Matrix4d found = geometry::closestSimilarity(from, to, scale != 1.0);
    EXPECT_LT((found.topLeftCorner<3, 3>() - scale * rotation).norm(), 1e-13);
    EXPECT_LT((found.topRightCorner<3, 1>() - shift).norm(), 1e-13);
  }
}

} // namespace
} // namespace dewpoint::tests
