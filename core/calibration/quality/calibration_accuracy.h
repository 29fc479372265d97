// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Prior knowledge about a calibration that is not part of its adjustment.
struct AccuracyPriors {
  double scaleSigma = 0.0; ///< relative standard deviation of the scale; 0: exact, or unknown
  bool scaleKnown =
      true; ///< false if the scale is a convention, so that its accuracy is not reported
  std::optional<double> upSigma; ///< standard deviation of the upward direction about each of two
                                 ///< axes, radians; nothing if up is a convention
};

/// Accuracy of a calibration. Errors are computed after the best-fitting rigid motion, so they do
/// not depend on the position of the origin.
struct CalibrationAccuracy {
  /// Error that is not exceeded at 95 % of the positions where the target was, meters.
  double position95 = 0.0;
  double cameras95 = 0.0; ///< part of position95 that is not reduced by averaging images, meters
  std::optional<double> scale95; ///< relative error of the scale, 95 %
  std::optional<double> up95;    ///< error of the upward direction, radians, 95 %
  /// Ratio between the actual change of the cameras when some instants are left out and the change
  /// predicted by their covariance. The covariance is increased accordingly. 1: the covariance was
  /// not changed.
  double modelFactor = 1.0;
  double heldOutPx = 0.0;   ///< root mean square reprojection error in left-out instants, pixels
  std::size_t heldOut = 0;  ///< number of image points in left-out instants
  double changeRatio = 0.0; ///< measured ratio from which modelFactor is derived
};

/// Assesses the accuracy of an adjustment from its outcome (problem and result in the world frame
/// of the result).
///
/// The covariance of the cameras is propagated to first order to positions spread over the observed
/// ones (Hartley & Zisserman, Multiple View Geometry, 5.2), without their common rigid motion. Then
/// the noise from one image of the target is added, and the 95 % values are determined from 200
/// draws.
///
/// For cross-validation, the instants are divided into 20 stretches, and each fifth of these is
/// left out in turn. The left-out image points are compared with cameras calibrated without them.
/// The spread of the five solutions (jackknife over stretches, Efron & Stein 1981) is the empirical
/// error. If it is clearly larger than predicted, the errors are not independent as assumed, and
/// the prediction is increased to match it.
///
/// Errors: those of adjustBundle(), and Undetermined without free cameras or observed positions.
Result<CalibrationAccuracy> assessCalibration(const BundleProblem& problem,
                                              const BundleResult& result,
                                              const AccuracyPriors& known = {});

/// Assesses the accuracy of a calibration by wand. `floorTimes` are those of its WandProblem.
Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes);

/// Returns a sentence about the accuracy: "In this volume +-3.1 mm (95 %), scale +-0.10 %, up
/// +-0.20 degrees."
std::string accuracySummary(const CalibrationAccuracy& accuracy);

} // namespace dewpoint::calibration
