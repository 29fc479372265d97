// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/geometry/camera.h"

namespace dewpoint::tests {

/// A camera of a usual webcam's lens.
inline Camera testCamera(int width = 640, int height = 480) {
  Camera camera;
  camera.intrinsics = {
      width, height, 0.85 * width, 0.85 * width, 0.5 * width - 3.0, 0.5 * height + 4.0};
  camera.distortion = {-0.18, 0.06, 0.001, -0.0008, 0.0};
  return camera;
}

/// A board whose middle is at `middle` (camera frame, meters), tilted about x and y, rolled.
inline Eigen::Isometry3d boardAt(const BoardDescription& board, const Eigen::Vector3d& middle,
                                 double tiltX, double tiltY, double roll = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(tiltX, Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(tiltY, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  pose.translation() = middle - pose.linear() * board.center();
  return pose;
}

} // namespace dewpoint::tests
