// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"

#include <map>
#include <vector>

namespace dewpoint::calibration {

/// A view with the board's pose before the camera.
struct PosedView {
  std::size_t camera = 0;
  const BoardView* view = nullptr;
  BoardDetection detection; ///< counted so that the cameras agree, where the board is symmetric
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  double rmsPx = 0.0;
};

/// Start values for the adjustment.
struct BoardChain {
  std::vector<Eigen::Isometry3d> cameraFromFirst;
  std::map<std::int64_t, Eigen::Isometry3d> firstFromBoard; ///< by instant
  std::vector<PosedView> views;
  std::vector<std::vector<ViewFit>> leftOut; ///< per camera: views without a pose
  std::vector<std::string> notices;
};

/// Poses of the board view by view, and of the cameras pair by pair; Undetermined names the cameras
/// that cannot be reached from the first.
Result<BoardChain> chainCameras(const ExtrinsicsRequest& request);

/// View `view` rotated by quarter turns of the board, with its pose.
PosedView rotatedView(const BoardDescription& board, const Camera& camera, const PosedView& view,
                      int quarterTurns);

} // namespace dewpoint::calibration
