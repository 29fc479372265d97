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

/// Lens model whose parameters are estimated.
enum class IntrinsicsModel {
  FiveCoefficients,  ///< pinhole with k1 k2 p1 p2 k3
  EightCoefficients, ///< also the rational coefficients k4 k5 k6, for wide-angle lenses
  Fisheye            ///< the model of cv::fisheye, k1 to k4
};

/// Assumption about the shape of pixels. Square pixels mean focalX = focalY.
enum class PixelShape {
  Measured, ///< square, unless the images clearly show otherwise
  Square,   ///< square: focalX = focalY
  Free      ///< not assumed: focalX and focalY are estimated separately
};

/// Input of calibrateIntrinsics(): the board, its views in one camera, and what to estimate. The
/// image width and height are in pixels.
struct IntrinsicsRequest {
  BoardDescription board;
  std::vector<BoardView> views;
  int width = 0;
  int height = 0;
  IntrinsicsModel model = IntrinsicsModel::FiveCoefficients;
  PixelShape pixelShape = PixelShape::Measured;
};

/// Estimated parameter and its standard deviation, in pixels or dimensionless.
struct EstimatedParameter {
  std::string name;
  double value = 0.0;
  double sigma = 0.0;
};

/// Information about the intrinsics in one view: its part of the normal equations, with the pose of
/// the board eliminated. Rows and columns are in the order of IntrinsicsResult::parameters. Corners
/// are assumed to have a standard deviation of one pixel.
struct ViewNormalEquations {
  std::int64_t instant = 0; ///< number of the time at which the view was taken (BoardView::instant)
  Eigen::MatrixXd information; ///< normal matrix of the intrinsics
  /// Right-hand side of the normal equations: `information` times the parameter step that fits this
  /// view best.
  Eigen::VectorXd gradient;
};

/// Intrinsics of one camera, with their accuracy.
struct IntrinsicsResult {
  Camera camera; ///< intrinsics, distortion and lens model; its pose is not determined
  /// Root mean square distance between all corners used and their projections, pixels (as defined
  /// by OpenCV).
  double rmsPx = 0.0;
  std::vector<ViewFit> views;
  std::vector<EstimatedParameter> parameters;
  Eigen::MatrixXd covariance; ///< covariance of `parameters`, in the same order
  /// Information about the intrinsics in each view used, in ascending order of instants.
  /// lensWithoutViews() needs it to leave out views.
  std::vector<ViewNormalEquations> viewNormalEquations;
  BoardCoverage coverage; ///< image regions and tilts covered by the views used
  /// Largest standard deviation of the projection of a ray across the image, in pixels; see
  /// projectionSigma().
  double maxProjectionSigmaPx = 0.0;
  /// Largest standard deviation of the projection of a ray across the image, in pixels, if the
  /// errors of all corners are assumed to be independent. It decreases with every added view, so it
  /// indicates whether there are enough views.
  double independentProjectionSigmaPx = 0.0;
};

/// Estimates intrinsics from images of a board with Zhang's method (2000), using OpenCV's
/// cv::calibrateCamera or cv::fisheye on all views together. A view is left out, and named in the
/// result, if its error is above five times the median error and above 0.25 % of the image
/// diagonal. Errors: Undetermined if fewer than three views remain; Canceled; BadValue if the views
/// do not determine a camera, or if nothing fits, for instance because the number of corners is
/// wrong.
Result<IntrinsicsResult> calibrateIntrinsics(const IntrinsicsRequest& request,
                                             const CalibrationProgress& progress = {});

/// Returns a first guess of a camera for images of this size in pixels. Its focal length is equal
/// to the image width.
Camera guessedCamera(int width, int height);

} // namespace dewpoint::calibration
