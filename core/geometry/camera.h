// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/projection.h"

#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

namespace dewpoint::geometry {

/// Pinhole intrinsics in pixels; pixel centers lie at integer coordinates.
struct Intrinsics {
  int width = 0;
  int height = 0;
  double focalX = 0.0;
  double focalY = 0.0;
  double centerX = 0.0;
  double centerY = 0.0;

  bool operator==(const Intrinsics&) const = default;
};

/// One calibrated camera. World: meters, right-handed, Z up. Camera axes as in OpenCV: x right,
/// y down, z forward. Distortion coefficients in OpenCV's order: k1 k2 p1 p2 k3 k4 k5 k6 of a
/// pinhole, k1 k2 k3 k4 (and zeros) of a fisheye.
struct Camera {
  std::string name;
  Intrinsics intrinsics;
  std::array<double, 8> distortion{};
  LensModel lens = LensModel::Pinhole;
  Eigen::Isometry3d cameraFromWorld = Eigen::Isometry3d::Identity();

  /// Optical center in the world frame, meters.
  Eigen::Vector3d center() const;
  /// Unit vector of the optical axis in the world frame.
  Eigen::Vector3d opticalAxis() const;

  /// True where pixels are not those of an ideal pinhole.
  bool distorted() const;

  bool operator==(const Camera& other) const;
};

using CameraRig = std::vector<Camera>;

/// The camera with the same lens at the origin of the world, along its axes.
Camera withoutPose(Camera camera);

/// The pose (camera from world) of a camera at `position` that looks at `target`, image up along
/// `up`, then rotated by `roll` radians about its optical axis. All in the world frame, meters.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                         const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(), double roll = 0.0);

} // namespace dewpoint::geometry
