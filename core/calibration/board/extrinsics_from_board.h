// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"
#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/bundle/fault.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Camera with known intrinsics, and its views of the board.
struct BoardCamera {
  Camera camera; ///< camera with known intrinsics; its pose is used only if it defines the world
  /// Views of different cameras that were taken at the same time have the same BoardView::instant.
  std::vector<BoardView> views;
  /// Standard deviation of the projection of a ray, in pixels, due to errors of the intrinsics of
  /// `camera`. It is the largest one in the image. Empty if unknown.
  std::optional<double> intrinsicsErrorPx = {};
};

/// Standard deviation of the projection of a ray, in pixels, above which intrinsics are too
/// inaccurate to calibrate with.
inline constexpr double kWorstRayPx = 10.0;
/// Standard deviation of the projection of a ray, as a fraction of the image width, above which the
/// intrinsics count as undetermined. Chosen by judgment.
inline constexpr double kUndeterminedRayShare = 0.25;

/// Input of calibrateExtrinsics(): the board, the cameras with their views of it, and settings.
struct ExtrinsicsRequest {
  BoardDescription board;
  std::vector<BoardCamera> cameras;
  /// Instant (BoardView::instant) at which the board has the pose `worldFromBoard`. This defines
  /// the world. If empty, the first camera keeps its pose, which defines the world.
  std::optional<std::int64_t> worldDefiningInstant;
  Eigen::Isometry3d worldFromBoard = worldFromFlatBoard();
  /// True to adjust the intrinsics as well: the focal lengths (a single one if both are equal), the
  /// principal point, and the distortion coefficients that are not zero. A camera keeps its
  /// intrinsics, and a notice names the camera, in two cases: its views do not determine the
  /// intrinsics (kUndeterminedRayShare), or the new intrinsics would be inaccurate (kWorstRayPx)
  /// and less accurate than BoardCamera::intrinsicsErrorPx.
  bool refinesIntrinsics = false;
};

/// Pose of the board at one instant (BoardView::instant).
struct BoardPose {
  std::int64_t instant = 0;
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// How well the views of one camera fit the calibration, and how accurate its pose is.
struct CameraFit {
  /// Root mean square distance between the corners used and their projections, pixels.
  double rmsPx = 0.0;
  std::vector<ViewFit> views;
  BoardCoverage coverage;
  /// Standard deviation of the camera position relative to the first camera, meters. Assumes that
  /// the errors of the corners are independent. setCameraSigmas() can replace the value by an
  /// estimate without this assumption.
  double centerSigma = 0.0;
  double rotationSigma = 0.0; ///< standard deviation of the camera orientation, radians
  bool isLensRefined = false; ///< true if the intrinsics were adjusted as well
};

/// Output of calibrateExtrinsics(): the camera poses estimated from views of a board.
struct ExtrinsicsResult {
  CameraRig cameras; ///< cameras with their new poses, in the order of the request
  std::vector<CameraFit> cameraFits;
  std::vector<BoardPose> boardPoses; ///< poses of the board, in ascending order of instants
  double rmsPx = 0.0;
  /// Covariance of the camera poses, scaled to match the size of the residuals.
  BundleCovariance covariance;
  int iterationCount = 0;
  std::vector<std::string> notices; ///< messages for the user
  BundleProblem problem; ///< bundle adjustment problem solved last, in the result's world frame
  /// Solution of `problem`. Its covariance assumes the pixel sigmas of `problem` and is not scaled
  /// to the residuals.
  BundleResult bundle;
  std::vector<DetectedFault> faults = {}; ///< mistakes found in the views, such as swapped cameras
};

/// Estimates the poses of all cameras from a board that several of them see at the same instants.
///
/// First, the pose of the board is computed in each view (cv::solvePnP). Then the pairs of cameras
/// that agree best form a chain that connects all cameras. Finally, all cameras and boards are
/// refined by bundle adjustment (adjustBundle). The corners of a symmetric chessboard are
/// renumbered so that pairs of cameras agree. Views that fit badly are left out and named in the
/// result.
///
/// Errors:
/// - NotFound if there is no camera;
/// - Undetermined, which names the cameras that share no instant with the others;
/// - Undetermined, which names `worldDefiningInstant`, if the board was not seen at that instant;
/// - Canceled;
/// - the errors of adjustBundle().
Result<ExtrinsicsResult> calibrateExtrinsics(const ExtrinsicsRequest& request,
                                             const CalibrationProgress& progress = {});

} // namespace dewpoint::calibration
