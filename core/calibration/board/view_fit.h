// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"
#include "core/geometry/camera.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Board as seen in one image of one camera.
struct BoardView {
  std::string name; ///< file or frame name that tells the user which image it is
  /// Number that identifies the time at which the image was taken. Images of different cameras with
  /// the same number show the board in the same pose.
  std::int64_t instant = 0;
  BoardDetection detection;
};

/// How well the corners of the board in one image fit the calibration.
struct ViewFit {
  std::string name;
  std::int64_t instant = 0;
  bool isUsed = true;
  /// True if the view is used although its error is more than three times the median error.
  bool isDoubtful = false;
  std::string reason; ///< why the view was left out or is doubtful
  /// Root mean square distance between the view's corners and their projections, pixels.
  double rmsPx = 0.0;
  /// Angle between the board's normal and the direction to the camera (tiltAngle()), radians.
  double tiltAngle = 0.0;
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  std::vector<int> ids;
  std::vector<Eigen::Vector2d> pixels; ///< measured positions of the corners
  /// Measured minus projected positions of the corners, pixels.
  std::vector<Eigen::Vector2d> residuals;
};

/// Computes the fit of a view to a camera and to a pose of the board relative to this camera. The
/// camera's own pose is not used.
ViewFit fitView(const BoardDescription& board, const BoardView& view, const Camera& camera,
                const Eigen::Isometry3d& cameraFromBoard);

/// Creates the ViewFit of a view that is not used. `reason` tells the user why.
ViewFit leftOutView(const BoardView& view, std::string reason);

/// Returns the median RMS error of the views, pixels; 0 if there are no views.
double medianRms(const std::vector<ViewFit>& fits);

/// Returns the largest acceptable error of a view in pixels: five times the median error `median`,
/// but at least 0.25 % of the image diagonal.
double maxViewErrorPx(double median, const Intrinsics& image);

/// Marks used views as doubtful if their error is more than three times that of the median view.
void markDoubtful(std::vector<ViewFit>& fits);

/// Returns the root mean square distance between all corners in the used views and their
/// projections, pixels.
double overallRms(const std::vector<ViewFit>& fits);

/// Returns whether a detection has at least six corners, in at least two rows and two columns of
/// the board.
bool spansPlane(const BoardDescription& board, const BoardDetection& detection);

/// Estimates the pose of a board relative to a camera with known intrinsics, from at least four
/// corners. Returns nothing if the corners lie on one line.
std::optional<Eigen::Isometry3d> boardPose(const BoardDescription& board,
                                           const BoardDetection& detection, const Camera& camera);

} // namespace dewpoint::calibration
