// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/quality/block_jackknife.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Knowledge about the accuracy of a calibration that is not part of its adjustment.
struct AccuracyPriors {
  double scaleSigma = 0.0; ///< relative standard deviation of the scale; 0: exact, or unknown
  /// False if the scale is arbitrary; the accuracy of the scale is then not reported.
  bool isScaleKnown = true;
  /// Standard deviation of the upward direction about each of two horizontal axes, radians; empty
  /// if the upward direction is arbitrary.
  std::optional<double> upSigma;
  /// Function that returns the initial cameras without some of the images. Set if the intrinsics
  /// were estimated from the same images.
  InitialCamerasWithoutStates estimateInitialCamerasWithoutStates = nullptr;
};

/// Accuracy of one camera's pose. With a probability of 95 %, the error is at most 1.96 times these
/// values.
struct CameraAccuracy {
  /// Standard deviation of the position, meters; 0 if the pose was not estimated. It is relative to
  /// the camera with a fixed pose, or to the target if no camera has one.
  double positionSigma = 0.0;
  double rotationSigma = 0.0; ///< standard deviation of the orientation, radians
};

/// Accuracy of a calibration. Errors are computed after the best-fitting rigid motion, so they do
/// not depend on the position of the origin.
struct CalibrationAccuracy {
  /// Error that 95 % of the measured positions do not exceed, for a target in the region where the
  /// board or wand was during the calibration; meters.
  double positionError95 = 0.0;
  /// Part of positionError95 that is caused by errors of the cameras; meters. Averaging over
  /// several images does not reduce this part.
  double positionErrorFromCameras95 = 0.0;
  /// Error that 95 % of the positions outside the region of the board or wand do not exceed, if at
  /// least two cameras see them (findCommonView()); meters. This is an extrapolation, because
  /// nothing was observed there. Never below positionError95. Empty if there are too few such
  /// positions.
  std::optional<double> outsidePositionError95;
  /// Distance from the calibrated volume within which 95 % of the positions of
  /// `outsidePositionError95` lie, meters; 0 if `outsidePositionError95` is empty.
  double outsideRegionDepth = 0.0;
  /// Relative error of the scale, not exceeded with 95 % probability.
  std::optional<double> scaleError95;
  /// Error of the upward direction, radians; not exceeded with 95 % probability.
  std::optional<double> upAngleError95;
  /// Accuracy of each camera of the problem.
  std::vector<CameraAccuracy> cameras;
  /// Factor by which position errors in the cross-validation are larger than the covariance
  /// predicts; 1 if they are not clearly larger. The accuracies of positions, scale, upward
  /// direction and cameras already include the factor.
  double errorInflationFactor = 1.0;
  /// Root mean square reprojection error of the image points left out in the cross-validation,
  /// pixels.
  double leftOutRmsPx = 0.0;
  std::size_t leftOutPointCount = 0; ///< number of image points left out in the cross-validation
  /// Ratio of the errors in the cross-validation to the predicted errors; 0 if it is unknown. If
  /// the ratio is clearly above 1, errorInflationFactor is set to it and enlarges the reported
  /// errors.
  double crossValidationErrorRatio = 0.0;
};

/// Assesses the accuracy of an adjustment. `problem` and `result` are in the world frame of the
/// result.
///
/// The covariance of the cameras is propagated to first order to positions (Hartley & Zisserman,
/// Multiple View Geometry, 5.2). The positions are a selection of those where the target was
/// observed. A common rigid motion of all positions is not an error. Then the image noise of a
/// single measurement is added, and the 95 % values are determined from 200 draws.
///
/// For cross-validation, the cameras are calibrated again without each of ten blocks of neighboring
/// states (leaveOutBlocks()). The left-out image points are compared with the cameras calibrated
/// without them. The scatter of the solutions is the empirical error of positions, scale, and each
/// camera. If it is larger than the predicted error, the errors are not independent as assumed, and
/// the empirical error is returned instead.
///
/// Error: Undetermined if no camera was free, or if two cameras saw the target at fewer than four
/// positions.
Result<CalibrationAccuracy> assessCalibration(const BundleProblem& problem,
                                              const BundleResult& result,
                                              const AccuracyPriors& known = {});

/// Assesses the accuracy of a calibration by wand. `floorTimes`: times when ball 0 lay on the floor
/// or touched it, seconds.
Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes);

/// Returns a text about the accuracy, for example "In this volume +-3.1 mm (95 %), scale +-0.10 %,
/// up +-0.20 degrees. Outside it, up to 0.8 m away, +-9.4 mm (extrapolated)."
std::string accuracySummary(const CalibrationAccuracy& accuracy);

} // namespace dewpoint::calibration
