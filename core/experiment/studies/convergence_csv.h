// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/convergence_study.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// A row per case: name, ball, start and half size of the start box (m), first seed, runs,
/// converged runs and those of them within 3 cm, and of the converged ones the median of
/// iterations, RMSE and bias along the optical axis (mm), which are empty where no run converged.
std::string convergenceCsv(const std::vector<ConvergenceResult>& results);

/// How far the cloud drifts with one camera, see measureDrift().
struct DriftResult {
  std::uint64_t firstSeed = kFirstTuningSeed;
  int runs = 0;
  int iterations = 0;
  double meters = 0.0; ///< per iteration
};
/// A row per result, millimeters per iteration.
std::string driftCsv(const std::vector<DriftResult>& results);

} // namespace dewpoint::experiment
