// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// What is known of a calibration beside its adjustment.
struct AccuracyKnowledge {
  double scaleSigma = 0.0; ///< relative standard deviation of the size; 0: exact, or not known
  bool scaleKnown = true;  ///< else the size is a convention, and nothing is reported about it
  std::optional<double> upSigma; ///< radians, about each of two axes; nothing: up is a convention
};

/// How good a calibration is, in numbers. Errors are those after the best rigid motion: what does
/// not depend on where the origin was put.
struct CalibrationAccuracy {
  /// Meters: 95 % of the positions where the target was are nearer than this.
  double position95 = 0.0;
  double cameras95 = 0.0;        ///< meters: the part of it that no averaging of images takes away
  std::optional<double> scale95; ///< relative
  std::optional<double> up95;    ///< radians
  /// By how much more the cameras change than their covariance says when a share of the instants is
  /// left out; the covariance is widened by it. 1: the covariance was believed.
  double modelFactor = 1.0;
  double heldOutPx = 0.0;   ///< root mean square distance in instants that were left out
  std::size_t heldOut = 0;  ///< image points in them
  double changeRatio = 0.0; ///< what was found before it was assessed: see modelFactor
};

/// The accuracy of an adjustment from its outcome (both in the result's world).
///
/// The covariance of the cameras is propagated to positions spread over those that were seen, by
/// first order (Hartley & Zisserman, Multiple View Geometry, 5.2), without their common rigid
/// motion; noise of one image of the target is added, and the 95 % are read off 200 draws. Held
/// out: the instants are cut into 20 stretches, and each fifth of these is left out in turn; the
/// left-out image points are compared with cameras found without them, and the spread of those five
/// solutions (jackknife over stretches, Efron & Stein 1981) is the empirical error: when it is
/// clearly larger than predicted, errors are not the independent ones that were assumed, and the
/// prediction is widened to it.
/// Errors: those of adjustBundle(), and Undetermined without free cameras or seen positions.
Result<CalibrationAccuracy> assessCalibration(const BundleProblem& problem,
                                              const BundleResult& result,
                                              const AccuracyKnowledge& known = {});

/// The same for a wand; `floorTimes` are those of its WandProblem.
Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes);

/// "In this volume +-3.1 mm (95 %), scale +-0.10 %, up +-0.20 degrees."
std::string accuracySentence(const CalibrationAccuracy& accuracy);

} // namespace dewpoint::calibration
