// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Where a piece of the background is seen now instead of at `pixel`, and how that changes with a
/// turn of the camera.
struct BackgroundShift {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();                          ///< pixels
  Eigen::Matrix<double, 2, 3> byTurn = Eigen::Matrix<double, 2, 3>::Zero(); ///< pixels per radian
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of `shift`, by the images' noise; px²
};

/// A small turn of a camera about its center: the new cameraFromWorld is (1 + [turn]x) times the
/// old one.
struct CameraRotation {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< radians, camera axes
  double sigma = 0.0;        ///< standard error of its least known component, radians
  double significance = 0.0; ///< how many standard errors it is away from none
  int used = 0;              ///< shifts that agree with it
};

/// d(pixel) / d(turn) at a pixel; nothing where the lens has no direction there.
std::optional<Eigen::Matrix<double, 2, 3>> pixelsByTurn(const Camera& camera,
                                                        const Eigen::Vector2d& pixel);

/// The turn that most shifts agree on: least squares with Tukey's biweight, its scale from the
/// median of the residuals. Nothing for fewer than four shifts, or when fewer than four agree.
std::optional<CameraRotation> fitTurn(const std::vector<BackgroundShift>& shifts);

} // namespace dewpoint::camera_motion
