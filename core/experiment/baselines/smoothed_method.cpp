// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/smoothed_method.h"

#include "core/trajectory/smoother.h"

namespace dewpoint::experiment {

std::vector<std::vector<SphereEstimate>>
smoothedEstimates(const std::vector<std::vector<SphereEstimate>>& live, double framesPerSecond) {
  Trajectory trajectory;
  for (std::size_t frame = 0; frame < live.size(); ++frame) {
    for (std::size_t target = 0; target < live[frame].size(); ++target) {
      const SphereEstimate& estimate = live[frame][target];
      TrajectorySample& sample = trajectory.samples.emplace_back();
      sample.time = static_cast<double>(frame) / framesPerSecond;
      sample.frame = static_cast<std::int64_t>(frame);
      sample.target = std::to_string(target);
      sample.position = estimate.mean;
      sample.covariance = estimate.covariance;
      sample.isValid = estimate.isValid;
      if (estimate.measurement) {
        sample.measurement =
            PositionMeasurement{estimate.measurement->mean, estimate.measurement->covariance};
      }
    }
  }
  const Trajectory after = smoothedTrajectory(trajectory);
  auto result = live;
  std::size_t next = 0;
  for (auto& estimates : result) {
    for (SphereEstimate& estimate : estimates) {
      const TrajectorySample& sample = after.samples[next++];
      estimate.mean = sample.position;
      estimate.covariance = sample.covariance;
      estimate.isValid = sample.isValid;
    }
  }
  return result;
}

} // namespace dewpoint::experiment
