// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/truth_unit.h"

#include "core/trajectory/trajectory_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace dewpoint::trajectory {
namespace {

constexpr double kMillimeter = 0.001; ///< meters
constexpr double kCentimeter = 0.01;
/// Of the estimate's distance from the origin: units are a factor of ten apart, and a run that lost
/// its target half of the time still fits better than that.
constexpr double kFits = 0.5;

/// Where the positions of a trajectory are, on the whole.
struct Whereabouts {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double spread = 0.0; ///< root mean square distance from the center
  std::size_t count = 0;
};

/// Frames that a trajectory covers.
struct CoveredFrames {
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

CoveredFrames coveredFrames(const Trajectory& trajectory) {
  CoveredFrames span{std::numeric_limits<std::int64_t>::max(),
                     std::numeric_limits<std::int64_t>::min()};
  for (const TrajectorySample& sample : trajectory.samples) {
    if (sample.frame == kNoFrame) {
      return {};
    }
    span = {std::min(span.first, sample.frame), std::max(span.last, sample.frame)};
  }
  return span;
}

/// Samples outside the frames do not count, unless they have no frame.
Whereabouts whereaboutsOf(const Trajectory& trajectory, const CoveredFrames& frames) {
  Whereabouts found;
  double squares = 0.0;
  for (const TrajectorySample& sample : trajectory.samples) {
    const bool counts =
        sample.frame == kNoFrame || (sample.frame >= frames.first && sample.frame <= frames.last);
    if (counts && sample.position.allFinite()) {
      found.center += sample.position;
      squares += sample.position.squaredNorm();
      ++found.count;
    }
  }
  if (found.count > 0) {
    const auto count = static_cast<double>(found.count);
    found.center /= count;
    found.spread = std::sqrt(std::max(0.0, squares / count - found.center.squaredNorm()));
  }
  return found;
}

} // namespace

Trajectory toMeters(Trajectory trajectory, double unitInMeters) {
  for (TrajectorySample& sample : trajectory.samples) {
    sample.position *= unitInMeters;
    sample.covariance *= unitInMeters * unitInMeters;
    if (sample.measurement) {
      sample.measurement->position *= unitInMeters;
      sample.measurement->covariance *= unitInMeters * unitInMeters;
    }
    if (sample.bestParticle) {
      *sample.bestParticle *= unitInMeters;
    }
    if (sample.extent) {
      *sample.extent *= unitInMeters * unitInMeters;
    }
  }
  return trajectory;
}

std::optional<double> likelyTruthUnitInMeters(const Trajectory& estimate, const Trajectory& truth) {
  const CoveredFrames frames = coveredFrames(estimate);
  const Whereabouts found = whereaboutsOf(estimate, frames);
  const Whereabouts wanted = whereaboutsOf(truth, frames);
  if (found.count == 0 || wanted.count == 0) {
    return std::nullopt;
  }
  const double size = std::hypot(found.center.norm(), found.spread);
  const auto fits = [&](double unit) {
    return std::hypot((found.center - unit * wanted.center).norm(),
                      found.spread - unit * wanted.spread) < kFits * size;
  };
  if (fits(1.0)) {
    return std::nullopt;
  }
  for (const double unit : std::array{kMillimeter, kCentimeter}) {
    if (fits(unit)) {
      return unit;
    }
  }
  return std::nullopt;
}

} // namespace dewpoint::trajectory
