// SPDX-License-Identifier: GPL-3.0-or-later
// Decompositions of small matrices of a fixed size, by Eigen, that several files need and that cost
// each of them up to ten seconds; compiled in one place. Cheaper ones are Eigen's own.
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::geometry {

/// Eigenvalues of a symmetric matrix in rising order, and their unit vectors as columns.
template <int Rows> struct SmallEigen {
  Eigen::Matrix<double, Rows, 1> values;
  Eigen::Matrix<double, Rows, Rows> vectors;
};

/// Read the lower triangle only.
SmallEigen<2> symmetricEigen2(const Eigen::Matrix2d& matrix);
SmallEigen<3> symmetricEigen3(const Eigen::Matrix3d& matrix);

/// The orthogonal matrix that is nearest to this one, by its singular value decomposition.
Eigen::Matrix3d nearestOrthogonal(const Eigen::Matrix3d& matrix);

/// The transform [s R | t] that takes the points `from` closest to the points `to`, in the order of
/// both, by least squares; s is 1 unless `sized`. Umeyama 1991. Neither may be empty.
Eigen::Matrix4d closestSimilarity(std::span<const Eigen::Vector3d> from,
                                  std::span<const Eigen::Vector3d> to, bool sized);

} // namespace dewpoint::geometry
