// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// One camera as a file of another tool gives it, not yet checked.
struct CameraParts {
  std::string name;
  double width = 0.0; ///< pixels
  double height = 0.0;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity(); ///< [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]
  std::vector<double> distortion;                       ///< in the order of `lens`
  LensModel lens = LensModel::Pinhole;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); ///< camera from world
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// What the parts are called in that file, for the error's field.
struct CameraPartNames {
  std::string size;
  std::string matrix;
  std::string distortion;
  std::string rotation;
  std::string translation;
};

/// The camera of these parts, or the first of them that is wrong: a number that is not finite, a
/// size that is no whole number of pixels, skew, a focal length that is not positive, more
/// coefficients than the lens has, no rotation.
Result<Camera> checkedCamera(const CameraParts& parts, const std::string& file,
                             const CameraPartNames& fields);

/// The matrix of the intrinsics, and its inverse use.
Eigen::Matrix3d matrixOf(const Intrinsics& intrinsics);
Eigen::Matrix3d matrixOf(double focalX, double focalY, double centerX, double centerY);

/// The coefficients as a list that has as many as needed: 4 of a fisheye; else the smallest of 4, 5
/// and 8 (at least `fewest`) that leaves out zeros only.
std::vector<double> coefficientsOf(const Camera& camera, int fewest);

} // namespace dewpoint::calibration
