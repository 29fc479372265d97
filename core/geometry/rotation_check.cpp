// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_check.h"

#include "core/geometry/small_matrices.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

namespace dewpoint::geometry {
namespace {

constexpr double kRotationTolerance = 1e-3; // |RᵀR - 1|: published files carry 6 digits or more
constexpr double kExactRotation = 1e-12;    // what rounding in double precision leaves

} // namespace

tl::expected<Eigen::Matrix3d, std::string> checkedRotation(const Eigen::Matrix3d& matrix) {
  const double deviation =
      (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  // Eigen's maximum may pass over what is not a number.
  if (!matrix.allFinite() || !(deviation <= kRotationTolerance)) {
    return tl::make_unexpected(
        fmt::format("not a rotation: its rows are not orthonormal, off by {:.3g}", deviation));
  }
  if (matrix.determinant() < 0.0) {
    return tl::make_unexpected(std::string("not a rotation: it mirrors, its determinant is -1"));
  }
  if (deviation < kExactRotation) {
    return matrix; // so that what was saved comes back bit by bit
  }
  return nearestOrthogonal(matrix);
}

Eigen::Matrix3d rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

} // namespace dewpoint::geometry
