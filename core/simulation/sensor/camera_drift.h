// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// A camera that slowly rotates about its own center, as on a mount that warms up: by nothing at
/// time 0, towards `rotation` with the time constant `settleSeconds`.
struct CameraDrift {
  /// Axis times angle in the world frame, radians: a direction d from the camera is seen where
  /// the camera at rest would see the rotated direction.
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
  double settleSeconds = 5.0;
};

/// The rotation reached at `time`, seconds; the identity before 0.
Eigen::Matrix3d rotationAt(const CameraDrift& drift, double time);

/// Where a point of the world has to be for the camera at rest to see it as the rotated one does.
Eigen::Vector3d rotatedAbout(const Eigen::Vector3d& center, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& point);

/// The image (CV_32FC3) of `view`'s camera rotated by `rotation`, from that of the camera at rest:
/// a homography, exact for a pinhole and to a few hundredths of a pixel for a lens and the few
/// milliradians that this is meant for. The border repeats its last pixels.
cv::Mat rotatedImage(const RoomView& view, const cv::Mat& image, const Eigen::Matrix3d& rotation);

} // namespace dewpoint::simulation
