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

// The blocks of numbers that describe a camera in an adjustment.

/// Size of a pose block: a rotation vector (radians) relative to a fixed rotation, then the
/// position (meters).
inline constexpr int kPoseSize = 6;
inline constexpr int kLensSize = 12; ///< focalX, focalY / focalX, principal point, distortion

std::array<double, kLensSize> lensBlock(const Camera& camera);
void setLens(const std::array<double, kLensSize>& block, Camera& camera);

/// exp(turn): rotationOfVector(), to first order where that is exact to rounding, as its
/// derivative.
Eigen::Matrix3d turnRotation(const Eigen::Vector3d& turn);
/// d(exp(turn) y)/d(turn) = -[exp(turn) y]x J(turn), J the left Jacobian of SO(3) (Barfoot, State
/// Estimation for Robotics, eq. 7.77).
Eigen::Matrix3d turnDerivative(const Eigen::Vector3d& turn, const Eigen::Vector3d& rotatedPoint);

/// Everything about one observation that the solver does not change.
struct PixelCostSetup {
  LensModel lens = LensModel::Pinhole;
  Eigen::Matrix3d cameraRotation = Eigen::Matrix3d::Identity(); ///< camera from world, before turn
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0;
  double outlineShift = 0.0;
  /// A point of a board (in its frame) whose rotation, before its turn, is given; else a free
  /// point.
  std::optional<Eigen::Matrix3d> boardRotation;
  Eigen::Vector3d boardPoint = Eigen::Vector3d::Zero();
  int stateSize = 3;         ///< of a state's block: 3 point, 6 stick and board
  int pointAt = 0;           ///< where in the block the free point begins
  double time = 0.0;         ///< of the image, before the camera's offset, seconds
  std::vector<double> knots; ///< times of the states a free point is followed through, seconds
};

/// (predicted - observed) / sigma. Parameter blocks: pose, lens, time offset, then one state per
/// knot.
class PixelCost final : public ceres::CostFunction {
public:
  explicit PixelCost(PixelCostSetup setup);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

private:
  PixelCostSetup setup_;
};

/// (distance of both ends - length) / sigma. One block: the two ends of a stick.
class StickCost final : public ceres::SizedCostFunction<1, 6> {
public:
  StickCost(double length, double sigma) : length_(length), sigma_(sigma) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

private:
  double length_;
  double sigma_;
};

/// (block - start) / sigma, entry by entry; entries of sigma 0 have no prior.
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
