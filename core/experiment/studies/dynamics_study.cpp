// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/dynamics_study.h"

#include "core/tracking/barrera/dynamics_parameters.h"
#include "core/tracking/barrera/dynamics_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::experiment {
namespace {

ParameterValues parametersOf(const DynamicsSetup& setup) {
  ParameterValues parameters(dynamicsParameters());
  // Within the declared ranges by construction of the studies.
  (void)parameters.set("particles", setup.particleCount);
  (void)parameters.set("motion_sigma", setup.motionSigma);
  (void)parameters.set("observation_sigma", setup.observationSigma);
  (void)parameters.set("start_x", setup.startPosition.x());
  (void)parameters.set("start_y", setup.startPosition.y());
  (void)parameters.set("start_z", setup.startPosition.z());
  return parameters;
}

/// Root mean square distance of rows to their mean.
double spreadOf(const Eigen::ArrayXXd& rows) {
  return std::sqrt((rows.rowwise() - rows.colwise().mean()).square().rowwise().sum().mean());
}

using Path = std::function<Eigen::Vector3d(int)>;

/// A loop of its own: the method is given positions here, as in the paper, and there are no frames
/// for the loop over frames to take.
DynamicsRun follow(const DynamicsSetup& setup, const Path& truth, std::uint64_t seed,
                   const std::vector<int>& instants) {
  DynamicsTracker tracker(parametersOf(setup), {}, {});
  tracker.restart(seed);
  ThreadTeam team(1);
  DynamicsRun run;
  for (int k = 0; k < setup.iterationCount; ++k) {
    tracker.beginFrame(k, truth(k));
    const SphereEstimate estimate = tracker.iterate(team);
    run.errors.push_back((estimate.mean - truth(k)).norm());
    run.beliefSpreads.push_back(estimate.spread());
    Eigen::ArrayXXd cloud;
    Eigen::ArrayXd weights;
    tracker.copyParticles(setup.particleCount, cloud, weights);
    run.cloudSpreads.push_back(spreadOf(cloud));
    if (std::ranges::binary_search(instants, k)) {
      run.particleClouds.push_back(std::move(cloud));
    }
  }
  return run;
}

bool keepsUp(const DynamicsSetup& setup, double speed, int runs, std::uint64_t firstSeed) {
  constexpr double kLost = 0.25; // meters; chosen: far beyond the spread of a tracker that follows
  const Path path = [&](int k) { return Eigen::Vector3d(speed * k, 0.0, 0.0); };
  int kept = 0;
  for (int k = 0; k < runs; ++k) {
    const DynamicsRun run = follow(setup, path, firstSeed + static_cast<std::uint64_t>(k), {});
    kept += run.errors.back() < kLost ? 1 : 0;
  }
  return 2 * kept >= runs;
}

} // namespace

DynamicsRun runDynamics(const DynamicsSetup& setup, std::uint64_t seed,
                        const std::vector<int>& instants) {
  const Path path = [&](int k) {
    return k < setup.jumpIteration ? setup.positionBeforeJump : setup.positionAfterJump;
  };
  return follow(setup, path, seed, instants);
}

std::vector<double> measureMeanErrors(const DynamicsSetup& setup, int runs,
                                      std::uint64_t firstSeed) {
  std::vector<double> sums(static_cast<std::size_t>(setup.iterationCount), 0.0);
  for (int k = 0; k < runs; ++k) {
    const DynamicsRun run = runDynamics(setup, firstSeed + static_cast<std::uint64_t>(k));
    for (std::size_t at = 0; at < sums.size(); ++at) {
      sums[at] += run.errors[at] / runs;
    }
  }
  return sums;
}

int iterationsUntilErrorBelow(const std::vector<double>& errors, int from, int end, double bound) {
  int last = end; // the last one that is not below
  while (last > from && errors[static_cast<std::size_t>(last - 1)] < bound) {
    --last;
  }
  return last == end ? -1 : last - from + 1;
}

double findMaxTrackableSpeed(DynamicsSetup setup, int runs, std::uint64_t firstSeed) {
  // Chosen: the limit is known to a 256th of the interval in which it lies.
  constexpr int kSteps = 60;
  constexpr int kHalvings = 8;
  setup.startPosition = Eigen::Vector3d::Zero();
  setup.iterationCount = kSteps;
  double kept = 0.0;
  double lost = 10.0 * setup.motionSigma;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (kept + lost);
    (keepsUp(setup, middle, runs, firstSeed) ? kept : lost) = middle;
  }
  return kept;
}

double distanceAdvancedTowardFarObject(DynamicsSetup setup, int runs, std::uint64_t firstSeed) {
  static constexpr double kFar = 50.0; // meters; chosen: beyond what a step can reach
  constexpr int kSteps = 40;           // iterations of which the mean is taken; chosen
  setup.startPosition = Eigen::Vector3d::Zero();
  setup.iterationCount = kSteps;
  double advance = 0.0;
  for (int k = 0; k < runs; ++k) {
    const DynamicsRun run = follow(setup, [](int) { return Eigen::Vector3d(kFar, 0.0, 0.0); },
                                   firstSeed + static_cast<std::uint64_t>(k), {});
    advance += (run.errors.front() - run.errors.back()) / (kSteps - 1) / runs;
  }
  return advance;
}

} // namespace dewpoint::experiment
