// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/projection.h"

#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

namespace dewpoint::geometry {

/// Pinhole intrinsics in pixels. Pixel centers are at integer coordinates.
struct Intrinsics {
  int width = 0;
  int height = 0;
  double focalX = 0.0;
  double focalY = 0.0;
  double centerX = 0.0; ///< principal point, column
  double centerY = 0.0; ///< principal point, row

  bool operator==(const Intrinsics&) const = default;
};

/// Calibrated camera. World frame: meters, right-handed, z up. Camera axes as in OpenCV: x right, y
/// down, z forward. Distortion coefficients are in OpenCV's order: k1 k2 p1 p2 k3 k4 k5 k6 for a
/// pinhole; k1 k2 k3 k4, then zeros, for a fisheye.
struct Camera {
  std::string name;
  Intrinsics intrinsics;
  std::array<double, 8> distortion{};
  LensModel lens = LensModel::Pinhole;
  Eigen::Isometry3d cameraFromWorld = Eigen::Isometry3d::Identity();

  /// Returns the optical center in the world frame, meters.
  Eigen::Vector3d center() const;
  /// Returns the unit vector along the optical axis, in the world frame.
  Eigen::Vector3d opticalAxis() const;

  /// Returns whether the lens differs from an ideal pinhole.
  bool hasDistortion() const;

  bool operator==(const Camera& other) const;
};

/// All cameras of a project, in a fixed order.
using CameraRig = std::vector<Camera>;

/// Returns the same camera at the world origin, with its axes along the world axes.
Camera withoutPose(Camera camera);

/// Returns the pose (camera from world) of a camera at `position` that looks at `target`. The
/// upward direction of the image is as close to `up` as possible. The camera is then rotated by
/// `roll` radians about its optical axis. All vectors are in the world frame, meters.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                         const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(), double roll = 0.0);

} // namespace dewpoint::geometry
