// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>
#include <ceres/sized_cost_function.h>
#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

// Parameter blocks for a camera in an adjustment.

/// Number of values in a pose block, which holds the parameters of a camera's pose: a rotation
/// vector (radians) relative to a fixed rotation, then the camera's position (meters).
inline constexpr int kPoseSize = 6;
/// Number of values in a lens block, which holds the intrinsics of a camera: focalX, focalY /
/// focalX, principal point, distortion.
inline constexpr int kLensSize = 12;

/// Returns the intrinsics of a camera as a lens block: focalX, focalY / focalX, principal point,
/// distortion.
std::array<double, kLensSize> lensBlock(const Camera& camera);
/// Sets the intrinsics of a camera to those in a lens block (lensBlock()).
void setLens(const std::array<double, kLensSize>& block, Camera& camera);

/// Returns the rotation matrix exp(turn). Uses rotationFromVector(). For rotations so small that
/// the first-order approximation is exact to rounding, uses this approximation.
/// rotationExponentialDerivative() is the derivative of exactly this function.
Eigen::Matrix3d rotationExponential(const Eigen::Vector3d& turn);
/// Returns d(exp(turn) y)/d(turn) = -[exp(turn) y]x J(turn), with J the left Jacobian of SO(3)
/// (Barfoot, State Estimation for Robotics, eq. 7.77).
Eigen::Matrix3d rotationExponentialDerivative(const Eigen::Vector3d& turn,
                                              const Eigen::Vector3d& rotatedPoint);

/// Data of one observation that stays constant during the optimization.
struct PixelCostSetup {
  LensModel lens = LensModel::Pinhole;
  /// Fixed rotation from world to camera axes, to which the rotation vector in the pose block is
  /// relative.
  Eigen::Matrix3d cameraRotation = Eigen::Matrix3d::Identity();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0;
  double outlineShift = 0.0;
  /// For a point on a board: a fixed rotation of the board. The rotation vector in the state block
  /// of the board is relative to it. Nothing for a free point.
  std::optional<Eigen::Matrix3d> boardRotation;
  Eigen::Vector3d boardPoint = Eigen::Vector3d::Zero();
  int stateBlockSize = 3; ///< size of a state block: 3 for a point, 6 for a stick or board
  /// Index in the state block at which the coordinates of the free point start.
  int pointOffset = 0;
  double imageTime = 0.0; ///< time of the image without the camera's offset, seconds
  /// Times of the states between which a free point is interpolated, seconds.
  std::vector<double> knotTimes;
};

/// Residual of an observation, (predicted - observed) / sigma. Parameter blocks: pose, lens, time
/// offset, then one state per knot (state between which the point is interpolated). Without knots,
/// the last block is the observation's own state.
class PixelCost final : public ceres::CostFunction {
public:
  explicit PixelCost(PixelCostSetup setup);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

private:
  PixelCostSetup setup_;
};

/// Residual of a stick, (distance between its ends - length) / sigma. Its only parameter block
/// contains the positions of both ends.
class StickCost final : public ceres::SizedCostFunction<1, 6> {
public:
  StickCost(double length, double sigma) : length_(length), sigma_(sigma) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

private:
  double length_;
  double sigma_;
};

/// Residual of a prior, (block - start) / sigma for each entry. Entries with sigma 0 have no prior.
class PriorCost final : public ceres::CostFunction {
public:
  PriorCost(std::vector<double> start, std::vector<double> sigmas);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

private:
  std::vector<double> start_;
  std::vector<double> sigmas_;
};

} // namespace dewpoint::calibration
