// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"

#include <map>
#include <vector>

namespace dewpoint::calibration {

/// A view of the board, with the board pose relative to the camera.
struct PosedView {
  std::size_t camera = 0;
  const BoardView* view = nullptr;
  BoardDetection
      detection; ///< on symmetric boards, the corners are numbered so that the cameras agree
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  double rmsPx = 0.0;
};

/// Start values for bundle adjustment.
struct BoardChain {
  std::vector<Eigen::Isometry3d> cameraFromFirst;
  std::map<std::int64_t, Eigen::Isometry3d>
      firstFromBoard; ///< board poses in the frame of the first camera, by instant
  std::vector<PosedView> views;
  std::vector<std::vector<ViewFit>> leftOut; ///< views without a pose, per camera
  std::vector<std::string> notices;
};

/// Computes the pose of the board in each view, and the relative poses of the cameras from pairs.
/// Undetermined names the cameras that are not connected to the first one.
Result<BoardChain> chainCameras(const ExtrinsicsRequest& request);

/// Returns `view` with the board rotated by a number of quarter turns, and with the corresponding
/// pose.
PosedView rotatedView(const BoardDescription& board, const Camera& camera, const PosedView& view,
                      int quarterTurns);

} // namespace dewpoint::calibration
