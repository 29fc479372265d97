// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Displacement of a background patch in the image, and the derivative of the displacement with
/// respect to a camera rotation.
struct BackgroundShift {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< displacement of the patch, pixels
  /// Derivative of `shift` with respect to CameraRotation::turn, pixels per radian.
  Eigen::Matrix<double, 2, 3> shiftJacobian = Eigen::Matrix<double, 2, 3>::Zero();
  /// Covariance of `shift` due to image noise, px².
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Small rotation of a camera about its center. To first order, the new cameraFromWorld is (I +
/// [turn]x) times the old cameraFromWorld, where I is the identity and [turn]x is the cross-product
/// matrix of `turn`.
struct CameraRotation {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< rotation vector, radians, camera axes
  double sigma = 0.0;        ///< standard error of the least certain component of `turn`, radians
  double significance = 0.0; ///< angle of the rotation divided by its standard error
  int usedShiftCount = 0;    ///< number of patch displacements that agree with the rotation
};

/// Returns the derivative (pixels per radian) of the image position of a world point with respect
/// to CameraRotation::turn, for a point seen at `pixel`. Returns nothing if the lens model has no
/// direction for the pixel.
std::optional<Eigen::Matrix<double, 2, 3>> rotationJacobian(const Camera& camera,
                                                            const Eigen::Vector2d& pixel);

/// Fits the camera rotation that explains most of the shifts. Method: least squares with Tukey's
/// biweight, whose width is proportional to the median residual. Returns nothing if fewer than four
/// shifts agree with the rotation.
std::optional<CameraRotation> fitRotation(const std::vector<BackgroundShift>& shifts);

} // namespace dewpoint::camera_motion
