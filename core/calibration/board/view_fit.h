// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"
#include "core/geometry/camera.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A board in one picture of one camera.
struct BoardView {
  std::string name;         ///< file, or frame: by which the user finds the picture
  std::int64_t instant = 0; ///< pictures of the same instant show the board at the same position
  BoardDetection detection;
};

/// How well one picture fits the result.
struct ViewFit {
  std::string name;
  std::int64_t instant = 0;
  bool used = true;
  bool doubtful = false; ///< used, but more than three times as far off as the median picture
  std::string reason;    ///< why it was left out, or is doubtful
  double rmsPx = 0.0;    ///< root mean square distance of its corners
  double tilt = 0.0;     ///< tiltAngle(), radians
  Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
  std::vector<int> ids;
  std::vector<Eigen::Vector2d> pixels;    ///< as measured
  std::vector<Eigen::Vector2d> residuals; ///< measured less projected, pixels
};

/// The fit of a view to a camera (its own pose is not used) and a pose of the board before it.
ViewFit fitView(const BoardDescription& board, const BoardView& view, const Camera& camera,
                const Eigen::Isometry3d& cameraFromBoard);

/// A view that is not used, and why.
ViewFit leftOutView(const BoardView& view, std::string reason);

/// Median of the views' errors, pixels; 0 without views.
double medianRms(const std::vector<ViewFit>& fits);

/// How far off a view may be, pixels, when the median one is off by `median`: five times that, and
/// 0.25 % of the image's diagonal in any case.
double badViewLimit(double median, const Intrinsics& image);

/// Marks the used views as doubtful that are three times as far off as the median one.
void markDoubtful(std::vector<ViewFit>& fits);

/// The root mean square distance of all corners of the views used, pixels.
double overallRms(const std::vector<ViewFit>& fits);

/// Whether corners are six at least, in two rows and two columns at least.
bool spansPlane(const BoardDescription& board, const BoardDetection& detection);

/// The pose of a board before a camera with known intrinsics, from four corners or more; nothing
/// when they are on one line.
std::optional<Eigen::Isometry3d> boardPose(const BoardDescription& board,
                                           const BoardDetection& detection, const Camera& camera);

} // namespace dewpoint::calibration
