// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/board.h"
#include "core/calibration/board/board_detection.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Pose of a board at rest in front of calibrated cameras.
struct BoardInRig {
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
  double rmsPx = 0.0;               ///< root mean square error of all corners, pixels
  std::vector<std::size_t> cameras; ///< indices of the cameras that see the board
};

/// Estimates the pose of a board from images that the cameras of a rig took at the same time. The
/// cameras do not change. The pose is first computed for each camera (boardPose()). The pose that
/// fits all images best is then refined with the corners of all cameras (adjustBundle(), Huber
/// loss).
///
/// `seen` has one entry per camera, which is empty if the camera does not see the board. Errors:
/// NotFound if no camera sees enough corners for a pose; Mismatch if the corners of several cameras
/// do not fit any pose, because the calibration is wrong or the board was moved between the images;
/// and those of adjustBundle().
Result<BoardInRig> locateBoardInRig(const BoardDescription& board, const CameraRig& rig,
                                    const std::vector<std::optional<BoardDetection>>& seen);

} // namespace dewpoint::calibration
