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

/// A camera with known intrinsics, and where it saw the board.
struct BoardCamera {
  Camera camera;                ///< its name names it in errors; its pose matters only as `World`
  std::vector<BoardView> views; ///< pictures of all cameras at one instant have one number
};

struct ExtrinsicsRequest {
  BoardDescription board;
  std::vector<BoardCamera> cameras;
  /// The instant at which the board lies where `worldFromBoard` says. Nothing: the first camera
  /// keeps the pose it has.
  std::optional<std::int64_t> worldInstant;
  Eigen::Isometry3d worldFromBoard = worldFromFlatBoard();
  /// Whether the lenses are adjusted too: what is not zero of them, a focal length where they are
  /// equal.
  bool refineIntrinsics = false;
};

/// Where the board was at an instant.
struct BoardPose {
  std::int64_t instant = 0;
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// How well one camera fits.
struct CameraFit {
  double rmsPx = 0.0; ///< root mean square distance of the corners used
  std::vector<ViewFit> views;
  BoardCoverage coverage;
  /// Standard deviation of its position, meters: against the first camera.
  double centerSigma = 0.0;
  double turnSigma = 0.0; ///< of its direction, radians
};

struct ExtrinsicsResult {
  CameraRig cameras; ///< in the order of the request
  std::vector<CameraFit> fits;
  std::vector<BoardPose> boardPoses; ///< in the order of the instants
  double rmsPx = 0.0;
  BundleCovariance covariance; ///< of the cameras' poses, for the residuals as found
  int iterations = 0;
  std::vector<std::string> notices;    ///< sentences worth saying
  BundleProblem problem;               ///< what was adjusted last, in the result's world
  BundleResult bundle;                 ///< and its outcome; its covariance: for sigmas of a pixel
  std::vector<NamedFault> faults = {}; ///< left to findBoardFaults()
};

/// The poses of all cameras from a board that several of them see at the same instants: poses of
/// the board before each camera (cv::solvePnP), chained from camera to camera through the pairs
/// that agree best, then bundle adjustment of all cameras and boards (adjustBundle). A symmetric
/// chessboard is rotated so that the pairs of cameras agree. Views that fit badly are left out and
/// named.
/// Errors: Undetermined names the cameras that share no instant with the others, and an instant at
/// which the board was not seen; Cancelled when cancelled; and those of adjustBundle().
Result<ExtrinsicsResult> calibrateExtrinsics(const ExtrinsicsRequest& request,
                                             const CalibrationProgress& progress = {});

} // namespace dewpoint::calibration
