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

/// Case of the convergence study: the position of the ball, the initial position of the cloud, and
/// the cameras. World frame, meters.
struct ConvergenceCase {
  std::string name;
  Eigen::Vector3d ballPosition;
  Eigen::Vector3d startPosition;
  /// Half sizes of the box in which the particles start, uniformly distributed; 0: they start at
  /// `startPosition`.
  Eigen::Vector3d startHalfSize = Eigen::Vector3d::Zero();
  int runCount = 100;
  int iterationCount = 150;
  CameraRig cameras = simulation::demoRig();
  /// True: there are books, boxes and other objects on the desk, which can hide the ball.
  bool hasClutter = true;
  std::uint64_t firstSeed = kFirstTuningSeed;
};

/// Results of the `barrera` method (Barrera et al. 2005) for a case, with one run per seed and one
/// iteration per frame. Convergence is determined from the spread of the particle cloud alone, see
/// convergenceIteration(). Errors are distances between the cloud's mean and the ball after
/// convergence.
struct ConvergenceResult {
  ConvergenceCase setup;
  int convergedRunCount = 0; ///< number of runs whose cloud has converged at the end
  int accurateRunCount = 0;  ///< number of converged runs with an RMSE below 3 cm after convergence
  double medianIterations =
      0.0;           ///< median number of iterations until convergence, over converged runs
  double rmse = 0.0; ///< RMSE over converged runs, from convergence on, meters
  /// Bias along camera 1's optical axis over converged runs, from convergence on, meters.
  double depthBias = 0.0;
};

/// Returns the iteration (counted from 1) from which on a particle cloud has converged. `spreads`
/// contains the spread of the cloud after each iteration: the root mean square distance of the
/// weighted particles from their mean, meters. The cloud has converged when the spread stays below
/// sqrt(3) * motionSigma, the spread that one motion step gives to a single point. Returns nothing
/// if the last spread is not below this limit.
std::optional<int> convergenceIteration(std::span<const double> spreads, double motionSigma);

/// Returns the cases of Barrera et al. 2005, section III. Ball positions, start volumes and camera
/// directions are chosen here, because the paper does not give them.
std::vector<ConvergenceCase> barreraConvergenceCases(int runs = 100,
                                                     std::uint64_t firstSeed = kFirstTuningSeed);

/// Returns the case of figures 3 and 4 of the paper: a bare desk with the ball. The cloud starts in
/// the view of camera 1, at the position given in the paper. The ball is 1.1 m from camera 1 and
/// completely visible in both images. Camera 2 is aimed at the ball. Camera 1 is aimed between the
/// ball and the start, which are 35 degrees apart in its view.
ConvergenceCase barreraFigure3Case(int runs = 100, std::uint64_t firstSeed = kFirstTuningSeed);

/// Runs one case with all its seeds and returns its results. The ball does not move.
Result<ConvergenceResult> studyConvergence(const ConvergenceCase& setup);

/// Callback after each iteration (counted from 1) of a run, with the run and its estimate.
using ConvergenceCallback =
    std::function<void(int iteration, const TrackingRun& run, const SphereEstimate& estimate)>;
/// Runs one seed of a case and calls `watch` after each iteration.
Status watchConvergence(const ConvergenceCase& setup, std::uint64_t seed,
                        const ConvergenceCallback& watch);

/// Returns, for each iteration, how far (meters) the mean of the particle cloud has moved away from
/// camera 1 since the start, averaged over runs; see measureDrift().
Result<std::vector<double>> measureDriftCurve(int runs, int iterations,
                                              std::uint64_t firstSeed = kFirstTuningSeed);

/// Returns the systematic drift of the particle cloud with a single camera (Barrera et al. 2005,
/// section III, figures 4 and 5), averaged over runs: how far the cloud's mean moves away from
/// camera 1 along its optical axis, in meters per iteration.
Result<double> measureDrift(int runs = 50, int iterations = 40,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
