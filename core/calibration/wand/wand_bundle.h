// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

namespace dewpoint::calibration {

/// Checks that there are at least two cameras, each with at least one view, and that all views are
/// valid. Errors name the camera.
Status checkViews(const WandProblem& problem);

/// Creates a bundle problem from the views and the initial cameras. Views whose times differ by at
/// most half the usual interval between views become observations of one state.
Result<BundleProblem> makeWandBundle(const WandProblem& problem);

/// Reduces a problem to at most `most` states and their observations. The states that are kept are
/// evenly spread in time. With `inRuns`, groups of 30 neighboring states are kept or removed as a
/// whole, so that positions can still be interpolated between neighboring states.
BundleProblem subsampledBundle(const BundleProblem& problem, int most, bool inRuns);

/// Sets BundleObservation::outlineShift, which corrects for the size of the ball, in every
/// observation. It is computed from the cameras and states in `now`. `ballRadii`: radii of balls 0
/// and 1, meters.
void updateOutlineShifts(const std::array<double, 2>& ballRadii, const BundleResult& now,
                         BundleProblem& problem);

/// In each state, drops the observation with the largest residual if this residual exceeds `limit`
/// pixels. Returns the number of dropped observations, and adds the number dropped for each camera
/// to its entry in `dropped`.
std::size_t dropWorstObservations(const BundleResult& now, double limit, BundleProblem& problem,
                                  std::vector<std::size_t>& dropped);

/// Returns the median length of the residuals of used observations in pixels, for one camera, or
/// for all cameras if `camera` is -1.
double medianResidual(const BundleProblem& problem, const BundleResult& now, int camera = -1);

} // namespace dewpoint::calibration
