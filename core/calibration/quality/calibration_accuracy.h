// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Prior knowledge about a calibration that is not in its adjustment.
struct AccuracyKnowledge {
  double scaleSigma = 0.0; ///< relative standard deviation of the scale; 0: exact, or not known
  bool scaleKnown = true;  ///< false: the scale is a convention, and its accuracy is not reported
  std::optional<double> upSigma; ///< radians, about each of two axes; nothing: up is a convention
};

/// Accuracy of a calibration. Errors are those that remain after the best rigid motion, so they do
/// not depend on where the origin is.
struct CalibrationAccuracy {
  /// 95 % of the positions where the target was have a smaller error than this, meters.
  double position95 = 0.0;
  double cameras95 = 0.0; ///< part of position95 that averaging images does not reduce, meters
  std::optional<double> scale95; ///< relative error of the scale, 95 %
  std::optional<double> up95;    ///< error of the upward direction, 95 %, radians
  /// Ratio of the actual change of the cameras, when a share of the instants is left out, to the
  /// change predicted by their covariance; the covariance is increased accordingly. 1: the
  /// covariance was not changed.
  double modelFactor = 1.0;
  double heldOutPx = 0.0;   ///< root mean square distance in left-out instants
  std::size_t heldOut = 0;  ///< number of image points in left-out instants
  double changeRatio = 0.0; ///< measured ratio from which modelFactor is derived
};

/// Assesses the accuracy of an adjustment from its outcome (problem and result in the world of the
/// result).
///
/// The covariance of the cameras is propagated to first order to positions spread over the observed
/// ones (Hartley & Zisserman, Multiple View Geometry, 5.2), without their common rigid motion; the
/// noise of one image of the target is added, and the 95 % values are taken from 200 draws.
///
/// For cross-validation, the instants are divided into 20 stretches, and each fifth of these is
/// left out in turn. The left-out image points are compared with cameras that were calibrated
/// without them. The spread of those five solutions (jackknife over stretches, Efron & Stein 1981)
/// is the empirical error. If it is clearly larger than predicted, the errors are not independent
/// as assumed, and the prediction is increased to it.
///
/// Errors: those of adjustBundle(), and Undetermined without free cameras or observed positions.
Result<CalibrationAccuracy> assessCalibration(const BundleProblem& problem,
                                              const BundleResult& result,
                                              const AccuracyKnowledge& known = {});

/// Assesses the accuracy of a calibration by wand; `floorTimes` are those of its WandProblem.
Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes);

/// Sentence about the accuracy: "In this volume +-3.1 mm (95 %), scale +-0.10 %, up +-0.20
/// degrees."
std::string accuracySentence(const CalibrationAccuracy& accuracy);

} // namespace dewpoint::calibration
