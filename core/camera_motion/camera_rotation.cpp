// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/camera_rotation.h"

#include "core/base/statistics.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::camera_motion {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Shifts that determine a rotation.
constexpr std::size_t kFewestShifts = 4;
/// Rounds of reweighted least squares.
constexpr int kRounds = 12;
constexpr double kTukey = 4.685;     // 95 % efficiency for normal residuals
constexpr double kToSigma = 0.8493;  // median length of a normal vector of the plane to its sigma
constexpr double kLeastSigma = 0.02; // pixels: no patch is located better than that
constexpr double kStep = 1e-6;       // radians, of the differences

/// The inverse covariances.
std::vector<Eigen::Matrix2d> weightsOf(const std::vector<BackgroundShift>& shifts) {
  std::vector<Eigen::Matrix2d> weights;
  weights.reserve(shifts.size());
  for (const BackgroundShift& one : shifts) {
    const Eigen::Matrix2d covariance =
        one.covariance + kLeastSigma * kLeastSigma * Eigen::Matrix2d::Identity();
    weights.emplace_back(covariance.inverse());
  }
  return weights;
}

/// In sigmas.
std::vector<double> residuals(const std::vector<BackgroundShift>& shifts,
                              const std::vector<Eigen::Matrix2d>& weights,
                              const Eigen::Vector3d& turn) {
  std::vector<double> result;
  result.reserve(shifts.size());
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    const Eigen::Vector2d off = shifts[i].shift - shifts[i].shiftJacobian * turn;
    result.push_back(std::sqrt(off.dot(weights[i] * off)));
  }
  return result;
}

/// The component-wise median shift, as a turn: what a robust fit starts from.
Eigen::Vector3d medianTurn(const std::vector<BackgroundShift>& shifts) {
  std::vector<double> columns, rows;
  Eigen::Matrix<double, 2, 3> shiftJacobian = Eigen::Matrix<double, 2, 3>::Zero();
  for (const BackgroundShift& one : shifts) {
    columns.push_back(one.shift.x());
    rows.push_back(one.shift.y());
    shiftJacobian += one.shiftJacobian / double(shifts.size());
  }
  const Eigen::Vector2d shift(upperMedian(std::move(columns)), upperMedian(std::move(rows)));
  // Without a turn about the optical axis, of which one shift says nothing.
  const Eigen::Vector2d turn = shiftJacobian.leftCols<2>().fullPivLu().solve(shift);
  return {turn.x(), turn.y(), 0.0};
}

} // namespace

std::optional<Eigen::Matrix<double, 2, 3>> rotationJacobian(const Camera& camera,
                                                            const Eigen::Vector2d& pixel) {
  Camera lens = camera;
  lens.cameraFromWorld.setIdentity();
  const auto direction = Unprojector(lens).worldDirection(pixel);
  if (!direction) {
    return std::nullopt;
  }
  const Projector projector(lens);
  Eigen::Matrix<double, 2, 3> shiftJacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis).cross(*direction);
    const auto ahead = projector.project(*direction + step);
    const auto behind = projector.project(*direction - step);
    if (!ahead || !behind) {
      return std::nullopt;
    }
    shiftJacobian.col(axis) = (*ahead - *behind) / (2.0 * kStep);
  }
  return shiftJacobian;
}

std::optional<CameraRotation> fitRotation(const std::vector<BackgroundShift>& shifts) {
  if (shifts.size() < kFewestShifts) {
    return std::nullopt;
  }
  CameraRotation result;
  result.turn = medianTurn(shifts);
  const auto weights = weightsOf(shifts);
  Eigen::Matrix3d normal;
  double scale = 1.0;
  for (int round = 0; round < kRounds; ++round) {
    const auto distances = residuals(shifts, weights, result.turn);
    scale = std::max(1.0, kToSigma * upperMedian(distances));
    normal.setZero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    result.usedShiftCount = 0;
    for (std::size_t i = 0; i < shifts.size(); ++i) {
      const double ratio = distances[i] / (kTukey * scale);
      if (ratio >= 1.0) {
        continue;
      }
      const double weight = (1.0 - ratio * ratio) * (1.0 - ratio * ratio);
      const Eigen::Matrix<double, 3, 2> weighted =
          weight * shifts[i].shiftJacobian.transpose() * weights[i];
      normal += weighted * shifts[i].shiftJacobian;
      right += weighted * shifts[i].shift;
      ++result.usedShiftCount;
    }
    if (result.usedShiftCount < int(kFewestShifts)) {
      return std::nullopt;
    }
    result.turn = normal.ldlt().solve(right);
  }
  const Eigen::Matrix3d inverse = normal.inverse();
  result.sigma = scale * std::sqrt(inverse.diagonal().maxCoeff());
  result.significance = std::sqrt(result.turn.dot(normal * result.turn)) / scale;
  return result.turn.allFinite() && std::isfinite(result.sigma) ? std::optional(result)
                                                                : std::nullopt;
}

} // namespace dewpoint::camera_motion
