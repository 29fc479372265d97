// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/seed_blocks.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace dewpoint::experiment {

/// An object that stands still, and at one iteration is elsewhere (Barrera et al. 2005, section
/// III-C). Meters. The paper states 2 m, iteration 30, 200 particles and sigma_m; not where the
/// cloud starts, nor the sigma of its observation.
struct DynamicsSetup {
  int particles = 200;
  double motionSigma = 0.03;
  double observationSigma = 0.1;
  Eigen::Vector3d start{0.0, -0.6, 0.0}; ///< of the cloud
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  Eigen::Vector3d after{2.0, 0.0, 0.0};
  int jump = 30; ///< the first iteration (from 0) that measures `after`
  int iterations = 100;
};

/// Method dynamics in one such run.
struct DynamicsRun {
  std::vector<double> errors; ///< meters, after each iteration
  /// Meters: root mean square distance of the particles to their mean after the prediction, all
  /// alike, as `clouds` shows them.
  std::vector<double> cloudSpreads;
  /// The same, weighted by what was observed: of the belief. Far from the object, where one
  /// particle has all the weight, it is nearly nothing.
  std::vector<double> beliefSpreads;
  std::vector<Eigen::ArrayXXd> clouds; ///< at the requested instants: rows x y z
};

/// One iteration per measurement. `instants`: iterations (ascending) whose clouds are kept.
DynamicsRun runDynamics(const DynamicsSetup& setup, std::uint64_t seed,
                        const std::vector<int>& instants = {});

/// The mean error of `runs` runs with seeds from `firstSeed` on after each iteration.
std::vector<double> meanErrors(const DynamicsSetup& setup, int runs,
                               std::uint64_t firstSeed = kFirstTuningSeed);

/// Iterations from `from` on until the error is below `bound` for good, at least up to `end`; -1
/// when it is not.
int iterationsUntilBelow(const std::vector<double>& errors, int from, int end, double bound);

/// Meters per iteration that a cloud can follow: the speed of a steadily moving object at which the
/// error stays below a quarter of a meter, by bisection over 60 iterations and `runs` seeds.
double speedLimit(DynamicsSetup setup, int runs, std::uint64_t firstSeed = kFirstTuningSeed);

/// Meters per iteration that the mean moves towards an object far away, mean of `runs` seeds: about
/// the expected largest of N standard normals times sigma_m (2.75 sigma_m at N = 200), since only
/// the nearest particle survives.
double farAdvance(DynamicsSetup setup, int runs, std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
