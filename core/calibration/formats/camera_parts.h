// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Camera as specified in a file from another tool, not yet checked.
struct CameraParts {
  std::string name;
  double width = 0.0; ///< image width, pixels
  double height = 0.0;
  /// Camera matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], pixels.
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  std::vector<double> distortion; ///< coefficients, in the order of `lens`
  LensModel lens = LensModel::Pinhole;
  /// Rotation from world axes to camera axes.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// Names of the parts of a camera in the file. They are used as the field in errors.
struct CameraFieldNames {
  std::string size;
  std::string matrix;
  std::string distortion;
  std::string rotation;
  std::string translation;
};

/// Returns the camera made of these parts. The error names the first invalid part: a number that is
/// not finite, a size that is not a whole number of pixels, skew, a focal length that is not
/// positive, more coefficients than the lens model has, or a matrix that is not a rotation.
Result<Camera> checkedCamera(const CameraParts& parts, const std::string& file,
                             const CameraFieldNames& fields);

/// Returns the camera matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] in pixels, from intrinsics or
/// from separate numbers.
Eigen::Matrix3d matrixOf(const Intrinsics& intrinsics);
Eigen::Matrix3d matrixOf(double focalX, double focalY, double centerX, double centerY);

/// Returns the distortion coefficients as the shortest possible list. A fisheye lens has 4
/// coefficients. For any other lens, these are the first 4, 5 or 8 coefficients, but at least
/// `fewest`. The coefficients that are omitted are zero.
std::vector<double> trimmedDistortion(const Camera& camera, int fewest);

} // namespace dewpoint::calibration
