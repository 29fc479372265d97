// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/truth_names.h"

#include "core/base/statistics.h"
#include "core/filter/assignment.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace dewpoint::experiment {
namespace {

using PositionsByFrame = std::map<std::int64_t, Eigen::Vector3d>;

std::map<std::string, PositionsByFrame> positionsByTarget(const Trajectory& trajectory) {
  std::map<std::string, PositionsByFrame> positions;
  for (const TrajectorySample& sample : trajectory.samples) {
    if (sample.position.allFinite()) {
      positions[sample.target][sample.frame] = sample.position;
    }
  }
  return positions;
}

/// Not finite, which forbids the pair, without a frame in common.
double medianDistance(const PositionsByFrame& estimate, const PositionsByFrame& truth) {
  std::vector<double> distances;
  for (const auto& [frame, position] : estimate) {
    if (const auto found = truth.find(frame); found != truth.end()) {
      distances.push_back((position - found->second).norm());
    }
  }
  return distances.empty() ? std::numeric_limits<double>::infinity()
                           : upperMedian(std::move(distances));
}

} // namespace

std::map<std::string, std::string>
truthNamesByPosition(const Trajectory& estimate, const Trajectory& truth,
                     const std::vector<std::vector<std::string>>& alike) {
  auto estimates = positionsByTarget(estimate);
  auto truths = positionsByTarget(truth);
  std::map<std::string, std::string> result;
  for (const std::vector<std::string>& names : alike) {
    const auto count = static_cast<Eigen::Index>(names.size());
    Eigen::MatrixXd cost(count, count);
    for (Eigen::Index row = 0; row < count; ++row) {
      for (Eigen::Index column = 0; column < count; ++column) {
        cost(row, column) = medianDistance(estimates[names[static_cast<std::size_t>(row)]],
                                           truths[names[static_cast<std::size_t>(column)]]);
      }
    }
    const Assignment assignment = assignMinimumCost(cost);
    if (assignment.pairCount < count) {
      continue; // one of them was never tracked, or has no truth: names are all there is
    }
    for (std::size_t row = 0; row < names.size(); ++row) {
      const auto column = static_cast<std::size_t>(assignment.columnOfRow[row]);
      if (column != row) {
        result[names[row]] = names[column];
      }
    }
  }
  return result;
}

Trajectory withTrackedNames(Trajectory truth,
                            const std::map<std::string, std::string>& truthNames) {
  std::map<std::string, std::string> trackedNames;
  for (const auto& [tracked, name] : truthNames) {
    trackedNames[name] = tracked;
  }
  for (TrajectorySample& sample : truth.samples) {
    if (const auto found = trackedNames.find(sample.target); found != trackedNames.end()) {
      sample.target = found->second;
    }
  }
  return truth;
}

} // namespace dewpoint::experiment
