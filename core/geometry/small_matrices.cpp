// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/small_matrices.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <iterator>

namespace dewpoint::geometry {
namespace {

template <int Rows> SmallEigen<Rows> smallEigen(const Eigen::Matrix<double, Rows, Rows>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Rows, Rows>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace

SmallEigen<2> symmetricEigen2(const Eigen::Matrix2d& matrix) {
  return smallEigen<2>(matrix);
}

SmallEigen<3> symmetricEigen3(const Eigen::Matrix3d& matrix) {
  return smallEigen<3>(matrix);
}

Eigen::Matrix3d nearestOrthogonal(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::Matrix4d closestSimilarity(std::span<const Eigen::Vector3d> from,
                                  std::span<const Eigen::Vector3d> to, bool scaleFree) {
  const auto columns = [](std::span<const Eigen::Vector3d> points) {
    return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, std::ssize(points));
  };
  return Eigen::umeyama(columns(from), columns(to), scaleFree);
}

} // namespace dewpoint::geometry
