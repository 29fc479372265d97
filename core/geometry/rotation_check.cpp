// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_check.h"

#include "core/geometry/small_matrices.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace dewpoint::geometry {
namespace {

constexpr double kRotationTolerance = 1e-3; // |RᵀR - 1|: published files carry 6 digits or more
constexpr double kExactRotation = 1e-12;    // what rounding in double precision leaves
constexpr double kOpposite =
    -1.0 + 1e-12; // cosine of vectors whose common normal is lost in rounding

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
  // As Eigen's FromTwoVectors, but for opposite vectors: there any half turn will do, and Eigen's
  // decomposition for it takes seconds to compile.
  const Eigen::Vector3d first = from.normalized();
  const Eigen::Vector3d second = to.normalized();
  const double cosine = second.dot(first);
  if (cosine < kOpposite) {
    return Eigen::AngleAxisd(std::numbers::pi, first.unitOrthogonal()).toRotationMatrix();
  }
  const double doubled = std::sqrt((1.0 + cosine) * 2.0);
  Eigen::Quaterniond turn;
  turn.vec() = first.cross(second) * (1.0 / doubled);
  turn.w() = doubled * 0.5;
  return turn.toRotationMatrix();
}

} // namespace dewpoint::geometry
