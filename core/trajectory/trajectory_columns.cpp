// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_columns.h"

#include "core/trajectory/trajectory_reader.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace dewpoint::trajectory {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// What a row stands for: a frame, or an instant where there are no frames.
using RowKey = std::pair<std::int64_t, double>;

RowKey rowKeyOf(const TrajectorySample& sample) {
  return {sample.frame, sample.frame == kNoFrame ? sample.time : 0.0};
}

TargetColumns emptyColumns(const std::string& target, std::size_t rows) {
  TargetColumns columns;
  columns.target = target;
  columns.positions.assign(3 * rows, kNothing);
  columns.covariances.assign(9 * rows, kNothing);
  columns.bestParticles.assign(3 * rows, kNothing);
  columns.existenceProbabilities.assign(rows, kNothing);
  columns.effectiveSampleSizes.assign(rows, kNothing);
  columns.cameraCounts.assign(rows, 0);
  columns.validFlags.assign(rows, 0);
  columns.ambiguousFlags.assign(rows, 0);
  return columns;
}

void put(const Eigen::Vector3d& vector, std::size_t row, std::vector<double>& column) {
  std::copy_n(vector.data(), 3, column.begin() + static_cast<std::ptrdiff_t>(3 * row));
}

void putSample(const TrajectorySample& sample, std::size_t row, TargetColumns& columns) {
  put(sample.position, row, columns.positions);
  // Symmetric: it is the same by rows and by columns.
  std::copy_n(sample.covariance.data(), 9,
              columns.covariances.begin() + static_cast<std::ptrdiff_t>(9 * row));
  if (sample.bestParticle) {
    put(*sample.bestParticle, row, columns.bestParticles);
  }
  columns.existenceProbabilities[row] = sample.existenceProbability;
  columns.effectiveSampleSizes[row] = sample.effectiveSampleSize;
  columns.cameraCounts[row] = sample.cameraCount;
  columns.validFlags[row] = sample.isValid ? 1 : 0;
  columns.ambiguousFlags[row] = sample.isAmbiguous ? 1 : 0;
}

} // namespace

TrajectoryColumns columnsOf(const Trajectory& trajectory) {
  std::map<RowKey, std::size_t> rows;
  for (const TrajectorySample& sample : trajectory.samples) {
    rows.emplace(rowKeyOf(sample), 0);
  }
  TrajectoryColumns columns;
  for (auto& [key, row] : rows) {
    row = columns.frames.size();
    columns.frames.push_back(key.first);
  }
  columns.times.assign(rows.size(), kNothing);
  std::map<std::string, std::size_t> places;
  for (const TrajectorySample& sample : trajectory.samples) {
    const auto [place, isNew] = places.emplace(sample.target, columns.targets.size());
    if (isNew) {
      columns.targets.push_back(emptyColumns(sample.target, rows.size()));
    }
    const std::size_t row = rows.at(rowKeyOf(sample));
    columns.times[row] = sample.time;
    putSample(sample, row, columns.targets[place->second]);
  }
  return columns;
}

} // namespace dewpoint::trajectory
