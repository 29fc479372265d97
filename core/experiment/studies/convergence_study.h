// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/session/run/tracking_run.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// One row of the study: where the ball lies, where the cloud starts and where the cameras stand
/// (world, meters).
struct ConvergenceCase {
  std::string name;
  Eigen::Vector3d ball;
  Eigen::Vector3d start;
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero(); ///< half sizes of a uniform box; 0: a point
  int runs = 100;
  int iterations = 150;
  CameraRig cameras = simulation::demoRig();
  bool clutter = true; ///< books, boxes and more on the desk, which hide a ball behind them
  std::uint64_t firstSeed = kFirstTuningSeed;
};

/// What `runs` seeds (from the first one on) of method `barrera` did from there, one iteration per
/// frame. Whether a cloud has converged is decided by the cloud alone, see convergedFrom(); how
/// near to the ball it then is, is measured.
struct ConvergenceResult {
  ConvergenceCase setup;
  int converged = 0;             ///< runs whose cloud has converged at the end
  int within = 0;                ///< of these, runs whose RMSE after convergence is below 3 cm
  double medianIterations = 0.0; ///< iterations until convergence, over the converged runs
  double rmse = 0.0;             ///< meters, all converged runs, iterations from convergence on
  double depthBias = 0.0;        ///< meters along camera 1's optical axis, same iterations
};

/// Iteration (from 1) from which a cloud has converged: from there to the end its spread (root mean
/// square distance of the weighted particles to their mean, meters) is below sqrt(3) sigma_m, by
/// which one step of motion alone scatters a point. The images then tell more than the motion
/// forgets. Nothing where the last spread is larger.
std::optional<int> convergedFrom(std::span<const double> spreads, double motionSigma);

/// The cases of Barrera et al. 2005, section III, completed where the paper is silent: ball
/// positions, start volumes, and where the cameras look.
std::vector<ConvergenceCase> barreraConvergenceCases(int runs = 100,
                                                     std::uint64_t firstSeed = kFirstTuningSeed);

/// The run of the paper's figures 3 and 4: a bare desk, the ball 1.1 m from camera 1 and whole in
/// both images, and the paper's start in camera 1's view. Camera 2 looks at the ball; camera 1
/// looks between the ball and the start, which are 35 degrees apart as it sees them.
ConvergenceCase figure3Case(int runs = 100, std::uint64_t firstSeed = kFirstTuningSeed);

/// Runs one case with a still ball.
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
/// moves away from camera 1 along its optical axis when only that camera is used; mean over runs.
Result<double> measureDrift(int runs = 50, int iterations = 40,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
