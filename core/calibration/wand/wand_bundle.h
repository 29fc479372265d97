// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

namespace dewpoint::calibration {

/// Checks that there are at least two cameras, each with valid views. The error names the camera.
Status checkViews(const WandProblem& problem);

/// Makes a bundle problem from the views and the initial cameras: views at the same time (within
/// half the usual time between two) become observations of one state.
Result<BundleProblem> wandBundle(const WandProblem& problem);

/// Keeps every k-th state, or every k-th run of neighbors where states are followed in time, so
/// that at most `most` remain, together with their observations.
BundleProblem thinned(const BundleProblem& problem, int most, bool inRuns);

/// Sets the outlineShift of every observation from the current cameras and states. `ballRadius` is
/// in meters.
void correctOutlines(const std::array<double, 2>& ballRadius, const BundleResult& now,
                     BundleProblem& problem);

/// Drops the worst observation of each state if its residual exceeds `limit` pixels. Returns the
/// number dropped; `dropped` counts them per camera.
std::size_t dropWorst(const BundleResult& now, double limit, BundleProblem& problem,
                      std::vector<std::size_t>& dropped);

/// Median length of the residuals of used observations in pixels, for all cameras or one.
double medianResidual(const BundleProblem& problem, const BundleResult& now, int camera = -1);

} // namespace dewpoint::calibration
