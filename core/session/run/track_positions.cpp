// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/track_positions.h"

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/tracking/barrera/dynamics_tracker.h"
#include "core/trajectory/trajectory_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr std::array<std::string_view, 3> kStart{"start_x", "start_y", "start_z"};
constexpr std::array<const char*, 3> kColumns{"x_m", "y_m", "z_m"};

using TrackerPtr = std::unique_ptr<DynamicsTracker>;

/// A filter that begins where the target was first measured.
Result<TrackerPtr> trackerAt(const Eigen::Vector3d& position, ParameterValues parameters,
                             std::uint64_t seed) {
  for (std::size_t axis = 0; axis < kStart.size(); ++axis) {
    const double value = position[static_cast<Eigen::Index>(axis)];
    if (const auto set = parameters.set(kStart[axis], value); !set) {
      return failure(
          ErrorCode::BadValue, "", kColumns[axis],
          fmt::format("{:g} is too far away to start a filter; the unit must be meters", value));
    }
  }
  auto tracker = std::make_unique<DynamicsTracker>(parameters, CameraRig{}, Target{});
  tracker->restart(seed);
  return tracker;
}

TrajectoryHeader headerOf(const ParameterValues& parameters, std::uint64_t seed) {
  TrajectoryHeader header;
  header.entries = {{"method", "dynamics"}, {"seed", std::to_string(seed)}};
  header.hasBestParticles = true;
  for (const auto& declaration : parameters.declarations()) {
    if (isStartPositionParameter(declaration.key)) {
      continue; // its own of each target
    }
    header.entries.emplace_back(declaration.key,
                                fmt::format("{}{}{}", parameters.at(declaration.key),
                                            declaration.unit.empty() ? "" : " ", declaration.unit));
  }
  return header;
}

/// Numbers the instants of samples that have times alone, in their order in time.
void numberInstants(Trajectory& measured) {
  std::set<double> times;
  for (const TrajectorySample& sample : measured.samples) {
    times.insert(sample.time);
  }
  for (TrajectorySample& sample : measured.samples) {
    if (sample.frame == kNoFrame) {
      sample.frame = std::distance(times.begin(), times.find(sample.time));
    }
  }
}

} // namespace

bool isStartPositionParameter(std::string_view key) {
  return std::ranges::find(kStart, key) != kStart.end();
}

Result<bool> addMissingTimes(Trajectory& measured, double rate) {
  const auto hasTime = [](const TrajectorySample& sample) { return std::isfinite(sample.time); };
  if (std::ranges::all_of(measured.samples, hasTime)) {
    numberInstants(measured);
    return false;
  }
  if (std::ranges::any_of(measured.samples, hasTime)) {
    return failure(ErrorCode::MissingKey, "", "time_s", "some rows have a time and others do not");
  }
  for (TrajectorySample& sample : measured.samples) {
    if (sample.frame == kNoFrame) {
      return failure(ErrorCode::MissingKey, "", "time_s", "no row has a time or a frame");
    }
    sample.time = static_cast<double>(sample.frame) / rate;
  }
  return true;
}

Result<Trajectory> trackPositions(const Trajectory& measured, const ParameterValues& parameters,
                                  std::uint64_t seed) {
  Trajectory tracked{headerOf(parameters, seed), {}};
  std::map<std::string, TrackerPtr> trackers;
  ThreadTeam team(1);
  std::map<std::string, std::int64_t> counts;
  for (const TrajectorySample& sample : measured.samples) {
    const bool usable = sample.isValid && sample.position.allFinite();
    TrackerPtr& tracker = trackers[sample.target];
    if (!tracker) {
      if (!usable) {
        continue; // nothing is known of it yet
      }
      const auto number = static_cast<std::uint32_t>(trackers.size() - 1);
      auto made = trackerAt(sample.position, parameters, derivedSeed(seed, number));
      if (!made) {
        return tl::make_unexpected(made.error());
      }
      tracker = std::move(*made);
    }
    tracker->beginFrame(counts[sample.target]++,
                        usable ? std::optional(sample.position) : std::nullopt);
    SphereEstimate estimate;
    for (int k = 0; k < tracker->iterationsPerFrame(); ++k) {
      estimate = tracker->iterate(team);
    }
    TrajectorySample result = sample;
    result.position = estimate.mean;
    result.bestParticle = estimate.best;
    result.covariance = estimate.covariance;
    result.effectiveSampleSize = estimate.effectiveSampleSize;
    result.cameraCount = 0;
    result.isValid = usable;
    result.existenceProbability = estimate.existenceProbability;
    tracked.samples.push_back(std::move(result));
  }
  return tracked;
}

} // namespace dewpoint::session
