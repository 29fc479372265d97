// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/board/view_fit.h"
#include "core/calibration/bundle/calibration_progress.h"
#include "core/geometry/camera.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// What is estimated of a lens.
enum class IntrinsicsModel {
  FiveCoefficients,  ///< pinhole with k1 k2 p1 p2 k3
  EightCoefficients, ///< pinhole with the rational k4 k5 k6 as well, for wide lenses
  Fisheye            ///< cv::fisheye's, k1 to k4
};

/// Whether pixels are as wide as high, that is focalX = focalY.
enum class PixelShape {
  Measured, ///< square, unless the pictures clearly say otherwise
  Square,
  Free
};

struct IntrinsicsRequest {
  BoardDescription board;
  std::vector<BoardView> views;
  int width = 0;
  int height = 0;
  IntrinsicsModel model = IntrinsicsModel::FiveCoefficients;
  PixelShape pixels = PixelShape::Measured;
};

/// An estimated number and its standard deviation, in pixels or without unit.
struct EstimatedParameter {
  std::string name;
  double value = 0.0;
  double sigma = 0.0;
};

/// The intrinsics of one camera, and how far to trust them.
struct IntrinsicsResult {
  Camera camera;      ///< intrinsics, distortion, lens; its pose is not determined
  double rmsPx = 0.0; ///< root mean square distance of all corners used (as OpenCV counts)
  std::vector<ViewFit> views;
  std::vector<EstimatedParameter> parameters;
  Eigen::MatrixXd covariance; ///< of `parameters`, in their order
  BoardCoverage coverage;     ///< of the views used
  /// The largest standard deviation, over the image, of where a ray is projected: see
  /// projectionSigma(). Pixels.
  double worstProjectionPx = 0.0;
};

/// Intrinsics from pictures of a board: Zhang (2000) with OpenCV's cv::calibrateCamera or
/// cv::fisheye, all views together. Views that fit badly (five times the median error and more than
/// 0.25 % of the image's diagonal) are left out and named. Undetermined when fewer than three views
/// remain; Cancelled when cancelled; BadValue when the views do not determine a camera, or nothing
/// fits, as with a wrong number of corners.
Result<IntrinsicsResult> calibrateIntrinsics(const IntrinsicsRequest& request,
                                             const CalibrationProgress& progress = {});

/// A guess to start with before anything is known: 1.0 x the width as focal length.
Camera guessedCamera(int width, int height);

} // namespace dewpoint::calibration
