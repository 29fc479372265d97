// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

namespace dewpoint::calibration {

/// Checks that there are at least two cameras, each with valid views. Errors name the camera.
Status checkViews(const WandProblem& problem);

/// Creates a bundle problem from the views and the initial cameras. Views at the same time (within
/// half the usual interval between views) become observations of one state.
Result<BundleProblem> wandBundle(const WandProblem& problem);

/// Reduces a problem to at most `most` states and their observations, by keeping every k-th state.
/// Where states are followed in time, keeps every k-th run of neighbors instead.
BundleProblem thinned(const BundleProblem& problem, int most, bool inRuns);

/// Sets the outlineShift of every observation based on the current cameras and states. `ballRadius`
/// is in meters.
void updateOutlineShifts(const std::array<double, 2>& ballRadius, const BundleResult& now,
                         BundleProblem& problem);

/// Drops the worst observation of each state if its residual exceeds `limit` pixels. Returns the
/// number of dropped observations; `dropped` counts them per camera.
std::size_t dropWorstObservations(const BundleResult& now, double limit, BundleProblem& problem,
                                  std::vector<std::size_t>& dropped);

/// Returns the median length of the residuals of used observations in pixels, for one camera or for
/// all.
double medianResidual(const BundleProblem& problem, const BundleResult& now, int camera = -1);

} // namespace dewpoint::calibration
