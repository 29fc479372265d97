// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Displacement of a background patch in the image, and its dependence on a camera rotation.
struct BackgroundShift {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< pixels
  Eigen::Matrix<double, 2, 3> byTurn =
      Eigen::Matrix<double, 2,
                    3>::Zero(); ///< derivative of `shift` by the rotation, pixels per radian
  Eigen::Matrix2d covariance =
      Eigen::Matrix2d::Zero(); ///< covariance of `shift` due to image noise, px²
};

/// Small rotation of a camera about its center: the new cameraFromWorld is (1 + [turn]x) times the
/// old one.
struct CameraRotation {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< radians, camera axes
  double sigma = 0.0;        ///< standard error of the least certain component of `turn`, radians
  double significance = 0.0; ///< size of the rotation in standard errors
  int used = 0;              ///< number of shifts that agree with the rotation
};

/// Returns the derivative d(pixel) / d(turn) at a pixel, in pixels per radian. Returns nothing
/// where the lens model has no direction for the pixel.
std::optional<Eigen::Matrix<double, 2, 3>> rotationJacobian(const Camera& camera,
                                                            const Eigen::Vector2d& pixel);

/// Fits the rotation that most shifts agree on, using least squares with Tukey's biweight, scaled
/// by the median of the residuals. Returns nothing if there are fewer than four shifts or if fewer
/// than four agree.
std::optional<CameraRotation> fitRotation(const std::vector<BackgroundShift>& shifts);

} // namespace dewpoint::camera_motion
