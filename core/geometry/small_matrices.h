// SPDX-License-Identifier: GPL-3.0-or-later
// Eigen's decompositions of small matrices of fixed size that several files need. Each would add up
// to ten seconds to the compilation of such a file, so they are compiled in one place. Cheaper ones
// are called directly from Eigen.
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::geometry {

/// Eigenvalues of a symmetric matrix in ascending order, and unit eigenvectors as columns.
template <int Rows> struct SmallEigen {
  Eigen::Matrix<double, Rows, 1> values;
  Eigen::Matrix<double, Rows, Rows> vectors;
};

/// Eigendecomposition of a symmetric matrix. Only the lower triangle is read.
SmallEigen<2> symmetricEigen2(const Eigen::Matrix2d& matrix);
SmallEigen<3> symmetricEigen3(const Eigen::Matrix3d& matrix);

/// Orthogonal matrix nearest to this one, by singular value decomposition.
Eigen::Matrix3d nearestOrthogonal(const Eigen::Matrix3d& matrix);

/// Least-squares similarity [s R | t] that maps the points `from` to the points `to`, in the order
/// of both (Umeyama 1991). The scale s is 1 unless `sized`. Neither list may be empty.
Eigen::Matrix4d closestSimilarity(std::span<const Eigen::Vector3d> from,
                                  std::span<const Eigen::Vector3d> to, bool sized);

} // namespace dewpoint::geometry
