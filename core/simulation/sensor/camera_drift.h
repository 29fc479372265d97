// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Slow rotation of a camera about its center, as on a mount that warms up. The rotation is zero at
/// time 0 and approaches `rotation` exponentially, with the time constant `settleSeconds`.
struct CameraDrift {
  /// Rotation as axis times angle in the world frame, radians. The rotated camera sees a direction
  /// d at the pixel where the camera at rest would see the rotated direction.
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
  double settleSeconds = 5.0;
};

/// Returns the rotation reached at `time` (seconds). The result is the identity before time 0.
Eigen::Matrix3d rotationAt(const CameraDrift& drift, double time);

/// Returns `point` after a rotation about the camera center (world frame, meters). The camera at
/// rest sees the returned point at the pixel where the rotated camera sees `point`.
Eigen::Vector3d rotatedAbout(const Eigen::Vector3d& center, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& point);

/// Returns the image (CV_32FC3) that the camera of `view` records after a rotation by `rotation`.
/// `image` is the image of the camera at rest. Method: a homography, which is exact for a pinhole
/// camera. For a lens with distortion and rotations of a few milliradians, the error is a few
/// hundredths of a pixel. Outside `image`, the border pixels are repeated.
cv::Mat rotatedImage(const RoomView& view, const cv::Mat& image, const Eigen::Matrix3d& rotation);

} // namespace dewpoint::simulation
