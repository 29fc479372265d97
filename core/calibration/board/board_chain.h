// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"

#include <map>
#include <vector>

namespace dewpoint::calibration {

/// View of the board, with the pose of the board relative to the camera.
struct PosedView {
  std::size_t camera = 0;
  const BoardView* view = nullptr;
  /// Detected corners of the board. Their numbers agree with those of the other cameras, even on a
  /// symmetric board.
  BoardDetection detection;
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  double rmsPx = 0.0;
};

/// Result of chainCameras(): start values of the camera and board poses for bundle adjustment.
struct BoardChain {
  /// For each camera, the transformation from the frame of the first camera to the frame of this
  /// camera; meters.
  std::vector<Eigen::Isometry3d> cameraFromFirstCamera;
  /// Board poses in the frame of the first camera. The key is the instant (BoardView::instant) at
  /// which the board had the pose.
  std::map<std::int64_t, Eigen::Isometry3d> firstCameraFromBoard;
  std::vector<PosedView> views;
  /// Views from which no board pose could be computed, per camera.
  std::vector<std::vector<ViewFit>> leftOutViews;
  std::vector<std::string> notices;
};

/// Computes start values for the poses of all cameras and boards. First, the pose of the board is
/// computed in each view. Then the relative pose of each pair of cameras is computed from the
/// instants (BoardView::instant) at which both cameras saw the board. The pairs with the most
/// instants that agree on one relative pose connect all cameras with the first one. Error:
/// Undetermined, which names the cameras that cannot be connected.
Result<BoardChain> chainCameras(const ExtrinsicsRequest& request);

/// Returns `view` for a board that is rotated about its normal by `quarterTurns` quarter turns. The
/// corners get other numbers, and the pose is that of the rotated board. The pixels stay the same.
PosedView rotatedView(const BoardDescription& board, const Camera& camera, const PosedView& view,
                      int quarterTurns);

} // namespace dewpoint::calibration
