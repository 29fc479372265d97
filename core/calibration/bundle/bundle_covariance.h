// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Camera parameter that an adjustment may estimate.
enum class CameraQuantity {
  /// Rotation error about the camera's x axis, radians. The true rotation is exp(v) times the
  /// estimate, where v contains the errors about all three axes.
  TurnX,
  TurnY,
  TurnZ,
  CenterX, ///< x coordinate of the optical center in the world, meters
  CenterY,
  CenterZ,
  Focal,  ///< focalX, pixels; focalY keeps its ratio to focalX
  Aspect, ///< focalY / focalX
  PrincipalX,
  PrincipalY,
  Distortion0, ///< first of the eight distortion coefficients, in lens model order
  Distortion1,
  Distortion2,
  Distortion3,
  Distortion4,
  Distortion5,
  Distortion6,
  Distortion7,
  TimeOffset, ///< offset added to the camera's times, seconds
};

/// Camera parameter to which one row and one column of the covariance belong.
struct CameraParameterColumn {
  std::size_t camera = 0;
  CameraQuantity quantity = CameraQuantity::TurnX;
};

/// Returns the name of a parameter, such as "turn x", "focal" or "k1".
std::string quantityName(CameraQuantity quantity);

/// Joint covariance of all free camera parameters, with the bodies eliminated.
///
/// If nothing determines the pose of the world (6 degrees of freedom) or its size (1), the pose or
/// the size is treated as exact. The covariance is then a pseudoinverse of the information matrix,
/// after each column was scaled by its own precision. Such a covariance is valid only for
/// quantities that do not depend on the choice of the world.
struct BundleCovariance {
  std::vector<CameraParameterColumn> columns;
  Eigen::MatrixXd matrix;
  int gaugeFreedomCount = 0; ///< degrees of freedom that nothing fixes: 0, 1 (size), 6 (pose) or 7
};

/// Returns the standard deviation of a camera's position in meters: the square root of the summed
/// variances of its three coordinates. 0 if the pose of the camera was not estimated.
double centerSigma(const BundleCovariance& covariance, std::size_t camera);
/// Returns the standard deviation of a camera's orientation in radians: the square root of the
/// summed variances of its three rotation components. 0 if the pose of the camera was not
/// estimated.
double rotationSigma(const BundleCovariance& covariance, std::size_t camera);

/// Computes the covariance of the first `cameraColumns` parameters. `jacobian` contains the
/// derivatives of the weighted residuals (rows) with respect to all parameters (columns). The
/// result is the inverse of the Schur complement, without the `gaugeFreedomCount` directions about
/// which it contains the least information. Returns nothing if further directions are undetermined.
std::optional<Eigen::MatrixXd> reducedCovariance(const Eigen::SparseMatrix<double>& jacobian,
                                                 Eigen::Index cameraColumns, int gaugeFreedomCount);

} // namespace dewpoint::calibration
