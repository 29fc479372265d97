// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/seed_blocks.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace dewpoint::experiment {

/// Setup with an object that stands still and jumps to another position at one iteration (Barrera
/// et al. 2005, section III-C). Meters. The paper specifies the jump of 2 m, iteration 30, 200
/// particles and sigma_m (`motionSigma`). It specifies neither the start of the cloud nor the sigma
/// of the observation.
struct DynamicsSetup {
  int particleCount = 200;
  double motionSigma = 0.03;
  double observationSigma = 0.1;
  Eigen::Vector3d startPosition{0.0, -0.6, 0.0}; ///< initial position of the cloud
  Eigen::Vector3d positionBeforeJump = Eigen::Vector3d::Zero();
  Eigen::Vector3d positionAfterJump{2.0, 0.0, 0.0};
  int jumpIteration =
      30; ///< first iteration (counted from 0) in which the object is at `positionAfterJump`
  int iterationCount = 100;
};

/// Results of one run of the `dynamics` method with a DynamicsSetup.
struct DynamicsRun {
  std::vector<double> errors; ///< error of the estimated position after each iteration, meters
  /// Root mean square distance of the particles from their mean after the prediction, meters. The
  /// particles are not weighted; `particleClouds` contains the same particles.
  std::vector<double> cloudSpreads;
  /// Weighted root mean square distance of the particles from their mean after the observation,
  /// meters: the spread of the belief. While the cloud is far from the object, one particle has
  /// almost all the weight, so this spread is almost zero.
  std::vector<double> beliefSpreads;
  std::vector<Eigen::ArrayXXd>
      particleClouds; ///< particles at the requested iterations, one row per particle: x y z
};

/// Runs the `dynamics` method with one iteration per measurement. `instants` lists the iterations
/// (ascending) whose particles are returned in `particleClouds`.
DynamicsRun runDynamics(const DynamicsSetup& setup, std::uint64_t seed,
                        const std::vector<int>& instants = {});

/// Returns the mean error of the estimated position after each iteration (meters) over `runs` runs,
/// with seeds from `firstSeed` on.
std::vector<double> measureMeanErrors(const DynamicsSetup& setup, int runs,
                                      std::uint64_t firstSeed = kFirstTuningSeed);

/// Returns the number of iterations, counted from `from`, until the error is below `bound` and
/// stays there at least up to `end`. Returns -1 if this does not happen.
int iterationsUntilErrorBelow(const std::vector<double>& errors, int from, int end, double bound);

/// Returns the largest speed, in meters per iteration, at which the cloud follows a steadily moving
/// object with an error below a quarter of a meter. The speed is found by bisection; each speed is
/// tested in runs of 60 iterations with `runs` seeds.
double findMaxTrackableSpeed(DynamicsSetup setup, int runs,
                             std::uint64_t firstSeed = kFirstTuningSeed);

/// Returns how far the cloud's mean moves toward a distant object per iteration, in meters,
/// averaged over `runs` seeds. Only the particle nearest to the object survives, so this is about
/// motionSigma times the expected maximum of N standard normal numbers, where N is the number of
/// particles (2.75 * motionSigma for N = 200).
double distanceAdvancedTowardFarObject(DynamicsSetup setup, int runs,
                                       std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
