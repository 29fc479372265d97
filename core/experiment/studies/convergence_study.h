// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/session/run/tracking_run.h"
#include "core/simulation/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// One row of the study: where the ball lies and where the cloud starts (world, meters).
struct ConvergenceCase {
  std::string name;
  Eigen::Vector3d ball;
  Eigen::Vector3d start;
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero(); ///< half sizes of a uniform box; 0: a point
  int runs = 100;
  int iterations = 150;
  std::uint64_t firstSeed = kFirstTuningSeed;
};

/// What `runs` seeds (from the first one on) of method `barrera` did from there, one iteration per
/// frame.
struct ConvergenceResult {
  ConvergenceCase setup;
  int converged = 0;             ///< runs whose error is below 3 cm (the paper's figure) at the end
  double medianIterations = 0.0; ///< iterations until it stays below, over the converged runs
  double rmse = 0.0;             ///< meters, converged runs, iterations after convergence
  double depthBias = 0.0;        ///< meters along camera 1's optical axis, same iterations
};

/// The cases of Barrera et al. 2005, section III, completed where the paper is silent: ball
/// positions, start volumes.
std::vector<ConvergenceCase> barreraConvergenceCases(int runs = 100,
                                                     std::uint64_t firstSeed = kFirstTuningSeed);

/// Runs one case on the demo's cameras and a still ball.
Result<ConvergenceResult> studyConvergence(const ConvergenceCase& setup);

/// One run of a case, iteration by iteration (from 1): the run after it, and what it believes.
using ConvergenceWatch =
    std::function<void(int iteration, const TrackingRun& run, const SphereEstimate& estimate)>;
Status watchConvergence(const ConvergenceCase& setup, std::uint64_t seed,
                        const ConvergenceWatch& watch);

/// As measureDrift(), after each iteration: meters that the mean has moved so far.
Result<std::vector<double>> driftCurve(int runs, int iterations,
                                       std::uint64_t firstSeed = kFirstTuningSeed);

/// The systematic drift (section III, figures 4 and 5): meters per iteration that the cloud's mean
/// moves away from camera 1 along its optical axis when only that camera looks; mean over runs.
Result<double> measureDrift(int runs = 50, int iterations = 40,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
