// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

namespace dewpoint::calibration {

/// Two cameras or more, each with views, and these usable; the error names the camera.
Status checkViews(const WandProblem& problem);

/// The views as a bundle problem on the initial cameras: views of the same instant (within half of
/// the usual time between two) become observations of one state.
Result<BundleProblem> wandBundle(const WandProblem& problem);

/// Every k-th state, or every k-th run of neighbors where they are followed in time, so that at
/// most `most` are left; their observations go along.
BundleProblem thinned(const BundleProblem& problem, int most, bool inRuns);

/// Sets every observation's outlineShift from the present cameras and states.
void correctOutlines(const std::array<double, 2>& ballRadius, const BundleResult& now,
                     BundleProblem& problem);

/// Drops, of every state, the worst observation that is off by more than `limit` pixels. Returns
/// how many; `dropped` counts them per camera.
std::size_t dropWorst(const BundleResult& now, double limit, BundleProblem& problem,
                      std::vector<std::size_t>& dropped);

/// The lengths of the residuals of used observations, of all cameras or one.
double medianResidual(const BundleProblem& problem, const BundleResult& now, int camera = -1);

} // namespace dewpoint::calibration
