// SPDX-License-Identifier: GPL-3.0-or-later
// Eigen's decompositions of small matrices of fixed size that several files need. Each one would
// add up to ten seconds to the compilation of such a file, so they are compiled in one place.
// Decompositions that compile faster are called directly from Eigen.
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

/// Computes the eigendecomposition of a symmetric matrix. Only the lower triangle is read.
SmallEigen<2> symmetricEigen2(const Eigen::Matrix2d& matrix);
SmallEigen<3> symmetricEigen3(const Eigen::Matrix3d& matrix);

/// Returns the orthogonal matrix nearest to the given matrix, by singular value decomposition.
Eigen::Matrix3d nearestOrthogonal(const Eigen::Matrix3d& matrix);

/// Returns the least-squares similarity [s R | t] that maps each point in `from` to the point with
/// the same index in `to` (Umeyama 1991). The scale s is estimated if `scaleFree` is set; otherwise
/// it is 1. Neither list may be empty.
Eigen::Matrix4d closestSimilarity(std::span<const Eigen::Vector3d> from,
                                  std::span<const Eigen::Vector3d> to, bool scaleFree);

} // namespace dewpoint::geometry
