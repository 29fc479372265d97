// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::tests {

/// Points on the x axis, as (identity, x): distances can be read off.
using PointsOnAxis = std::vector<std::pair<int, double>>;

inline std::vector<TrackPoint> pointsOnAxis(const PointsOnAxis& points) {
  std::vector<TrackPoint> result;
  for (const auto& [identity, x] : points)
    result.push_back({identity, Eigen::Vector3d(x, 0.0, 0.0)});
  return result;
}

inline TrackFrame frameOnAxis(const PointsOnAxis& truth, const PointsOnAxis& estimates,
                              std::int64_t frame = 0) {
  return {frame, 0.01 * static_cast<double>(frame), pointsOnAxis(truth), pointsOnAxis(estimates)};
}

} // namespace dewpoint::tests
