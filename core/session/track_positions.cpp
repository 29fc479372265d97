// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/track_positions.h"

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/tracking/dynamics_tracker.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>

namespace dewpoint {
namespace {

using TrackerPtr = std::unique_ptr<DynamicsTracker>;

/// A filter that begins where the target was first measured.
TrackerPtr trackerAt(const Eigen::Vector3d& place, ParameterValues parameters, std::uint64_t seed) {
  static constexpr const char* kAxes[] = {"start_x", "start_y", "start_z"};
  for (int axis = 0; axis < 3; ++axis) {
    (void)parameters.set(kAxes[axis], place[axis]); // out of range: the start that is set stays
  }
  auto tracker = std::make_unique<DynamicsTracker>(parameters, CameraRig{}, Target{});
  tracker->restart(seed);
  return tracker;
}

TrajectoryHeader headerOf(const ParameterValues& parameters, std::uint64_t seed) {
  TrajectoryHeader header;
  header.entries = {{"method", "dynamics"}, {"seed", std::to_string(seed)}};
  for (const auto& declaration : parameters.declarations()) {
    header.entries.emplace_back(declaration.key,
                                fmt::format("{}{}{}", parameters.at(declaration.key),
                                            declaration.unit.empty() ? "" : " ", declaration.unit));
  }
  return header;
}

} // namespace

Trajectory trackPositions(const Trajectory& measured, const ParameterValues& parameters,
                          std::uint64_t seed) {
  Trajectory tracked{headerOf(parameters, seed), {}};
  std::map<std::string, TrackerPtr> trackers;
  ThreadTeam team(1);
  std::map<std::string, std::int64_t> counts;
  for (const TrajectorySample& sample : measured.samples) {
    const bool usable = sample.valid && sample.position.allFinite();
    TrackerPtr& tracker = trackers[sample.target];
    if (!tracker) {
      if (!usable) {
        continue; // nothing is known of it yet
      }
      const auto number = static_cast<std::uint32_t>(trackers.size() - 1);
      tracker = trackerAt(sample.position, parameters, derivedSeed(seed, number));
    }
    tracker->beginFrame(counts[sample.target]++,
                        usable ? std::optional(sample.position) : std::nullopt);
    TargetEstimate estimate;
    for (int k = 0; k < tracker->iterationsPerFrame(); ++k) {
      estimate = tracker->iterate(team);
    }
    TrajectorySample result = sample;
    result.position = estimate.mean;
    result.covariance = estimate.covariance;
    result.effectiveSampleSize = estimate.effectiveSampleSize;
    result.cameras = 0;
    result.valid = usable;
    result.existence = estimate.existence;
    tracked.samples.push_back(std::move(result));
  }
  return tracked;
}

} // namespace dewpoint
