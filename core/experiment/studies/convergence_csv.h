// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/convergence_study.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns the results of the convergence study as CSV, one row per case: name, ball position,
/// start position and half size of the start box (m), first seed, number of runs, number of
/// converged runs, and number of converged runs with an RMSE below 3 cm. Three more cells, empty if
/// no run converged, are for the converged runs: median number of iterations, RMSE (mm), and bias
/// along the optical axis (mm).
std::string convergenceCsv(const std::vector<ConvergenceResult>& results);

/// Result of measuring the drift of the particle cloud away from a single camera; see
/// measureDrift().
struct DriftResult {
  std::uint64_t firstSeed = kFirstTuningSeed;
  int runCount = 0;
  int iterationCount = 0;
  double metersPerIteration = 0.0; ///< drift per iteration, meters
};
/// Returns the drift results as CSV, one row per result; the drift is in millimeters per iteration.
std::string driftCsv(const std::vector<DriftResult>& results);

} // namespace dewpoint::experiment
