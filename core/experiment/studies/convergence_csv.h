// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/convergence_study.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns CSV with one row per case: name, ball position, start position and half size of the
/// start box (m), first seed, number of runs, number of converged runs, and number of converged
/// runs with an RMSE below 3 cm. For the converged runs, the row also contains the median number of
/// iterations, the RMSE (mm), and the bias along the optical axis (mm). These cells are empty if no
/// run converged.
std::string convergenceCsv(const std::vector<ConvergenceResult>& results);

/// Drift of the particle cloud with one camera, see measureDrift().
struct DriftResult {
  std::uint64_t firstSeed = kFirstTuningSeed;
  int runs = 0;
  int iterations = 0;
  double meters = 0.0; ///< drift per iteration, meters
};
/// Returns CSV with one row per result, in millimeters per iteration.
std::string driftCsv(const std::vector<DriftResult>& results);

} // namespace dewpoint::experiment
