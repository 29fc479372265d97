// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// A camera that slowly rotates about its own center, as on a mount that warms up: from zero at
/// time 0 toward `rotation` with the time constant `settleSeconds`.
struct CameraDrift {
  /// Rotation as axis times angle in the world frame, radians: the camera sees a direction d where
  /// the camera at rest would see the rotated direction.
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
  double settleSeconds = 5.0;
};

/// Returns the rotation reached at `time`, seconds; the identity before 0.
Eigen::Matrix3d rotationAt(const CameraDrift& drift, double time);

/// Returns the position at which the camera at rest sees a point of the world as the rotated camera
/// does.
Eigen::Vector3d rotatedAbout(const Eigen::Vector3d& center, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& point);

/// Returns the image (CV_32FC3) of `view`'s camera rotated by `rotation`, from that of the camera
/// at rest. It uses a homography, which is exact for a pinhole camera, and accurate to a few
/// hundredths of a pixel for a lens and the intended rotations of a few milliradians. The border
/// repeats its last pixels.
cv::Mat rotatedImage(const RoomView& view, const cv::Mat& image, const Eigen::Matrix3d& rotation);

} // namespace dewpoint::simulation
