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

/// Lens parameters that are estimated.
enum class IntrinsicsModel {
  FiveCoefficients,  ///< pinhole with k1 k2 p1 p2 k3
  EightCoefficients, ///< pinhole with the rational k4 k5 k6 as well, for wide lenses
  Fisheye            ///< cv::fisheye's, k1 to k4
};

/// Whether pixels are square, that is focalX = focalY.
enum class PixelShape {
  Measured, ///< square, unless the images clearly show otherwise
  Square,
  Free
};

/// Input of calibrateIntrinsics(). Width and height of the images are in pixels.
struct IntrinsicsRequest {
  BoardDescription board;
  std::vector<BoardView> views;
  int width = 0;
  int height = 0;
  IntrinsicsModel model = IntrinsicsModel::FiveCoefficients;
  PixelShape pixels = PixelShape::Measured;
};

/// An estimated parameter and its standard deviation, in pixels or without unit.
struct EstimatedParameter {
  std::string name;
  double value = 0.0;
  double sigma = 0.0;
};

/// Intrinsics of one camera, with their accuracy.
struct IntrinsicsResult {
  Camera camera;      ///< intrinsics, distortion and lens; its pose is not determined
  double rmsPx = 0.0; ///< root mean square distance of all corners used, pixels (as OpenCV counts)
  std::vector<ViewFit> views;
  std::vector<EstimatedParameter> parameters;
  Eigen::MatrixXd covariance; ///< of `parameters`, in their order
  BoardCoverage coverage;     ///< of the views used
  /// Largest standard deviation over the image of the projection of a ray, in pixels; see
  /// projectionSigma().
  double worstProjectionPx = 0.0;
};

/// Intrinsics from pictures of a board: Zhang (2000) with OpenCV's cv::calibrateCamera or
/// cv::fisheye, all views together. Views that fit badly (five times the median error and more than
/// 0.25 % of the image's diagonal) are left out and named. Undetermined when fewer than three views
/// remain; Canceled when canceled; BadValue when the views do not determine a camera, or nothing
/// fits, as with a wrong number of corners.
Result<IntrinsicsResult> calibrateIntrinsics(const IntrinsicsRequest& request,
                                             const CalibrationProgress& progress = {});

/// Initial guess without any knowledge: the focal length is 1.0 times the image's width.
Camera guessedCamera(int width, int height);

} // namespace dewpoint::calibration
