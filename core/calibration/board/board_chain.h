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
  BoardDetection
      detection; ///< on symmetric boards, the corners are numbered so that the cameras agree
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  double rmsPx = 0.0;
};

/// Start values for bundle adjustment.
struct BoardChain {
  std::vector<Eigen::Isometry3d> cameraFromFirst;
  /// Board poses in the frame of the first camera, by BoardView::instant.
  std::map<std::int64_t, Eigen::Isometry3d> firstFromBoard;
  std::vector<PosedView> views;
  std::vector<std::vector<ViewFit>> leftOut; ///< views without a pose, per camera
  std::vector<std::string> notices;
};

/// Computes the pose of the board in each view. From the views that two cameras have at the same
/// instants, computes the relative pose of these cameras. The pairs with the most agreeing instants
/// connect all cameras with the first one. Error: Undetermined, which names the cameras that cannot
/// be connected.
Result<BoardChain> chainCameras(const ExtrinsicsRequest& request);

/// Returns the same view of a board that is rotated about its normal by `quarterTurns` quarter
/// turns: with renumbered corners and the corresponding pose.
PosedView rotatedView(const BoardDescription& board, const Camera& camera, const PosedView& view,
                      int quarterTurns);

} // namespace dewpoint::calibration
