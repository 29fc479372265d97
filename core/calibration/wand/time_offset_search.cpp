// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/wand/time_offset_search.h"

#include "core/base/statistics.h"
#include "core/calibration/wand/wand_bundle.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kMost = 0.5;             ///< seconds
constexpr double kOffsetStep = 0.5;       ///< of a frame's time
constexpr double kLongestGap = 2.5;       ///< frames between two views that are joined by a line
constexpr std::size_t kMostSamples = 300; ///< of one pair and offset
/// Samples of one pair and offset, at least.
constexpr std::size_t kFewestSamples = 60;
constexpr double kFewestShare = 0.6; ///< of those without any offset
constexpr int kTerms = 10;           ///< of a polynomial of second order in space
constexpr double kClearGain = 0.5;   ///< of what is left without any offset

/// Views of one ball by one camera, rising in time, with their rays.
struct TimedDirection {
  double time;
  Eigen::Vector3d direction;
};
struct Track {
  Eigen::Vector3d center;
  std::vector<TimedDirection> directions;
};

Track trackOf(const WandProblem& problem, std::size_t camera, std::size_t ball) {
  const Unprojector unprojector(problem.initialRig[camera]);
  Track track{unprojector.center(), {}};
  for (const MarkerObservation& view : problem.views[camera]) {
    const auto direction = unprojector.worldDirection(view.pixel);
    if (view.ball == ball && direction && std::isfinite(view.time)) {
      track.directions.push_back({view.time, *direction});
    }
  }
  std::ranges::stable_sort(track.directions, {}, &TimedDirection::time);
  return track;
}

/// The usual time between two views of a track; 0 if there is none.
double periodOf(const Track& track) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < track.directions.size(); ++i) {
    gaps.push_back(track.directions[i].time - track.directions[i - 1].time);
  }
  return upperMedian(std::move(gaps));
}

std::optional<Eigen::Vector3d> directionAt(const Track& track, double time, double longestGap) {
  const auto after = std::ranges::lower_bound(track.directions, time, {}, &TimedDirection::time);
  if (after == track.directions.begin() || after == track.directions.end()) {
    return std::nullopt;
  }
  const TimedDirection& late = *after;
  const TimedDirection& early = *std::prev(after);
  const double gap = late.time - early.time;
  if (!(gap > 0.0) || gap > longestGap) {
    return std::nullopt;
  }
  const double part = (time - early.time) / gap;
  return ((1.0 - part) * early.direction + part * late.direction).normalized();
}

/// Where two rays pass each other, and by how far, with a sign.
struct Passing {
  Eigen::Vector3d middle;
  double gap;
};

std::optional<Passing> passing(const Eigen::Vector3d& a, const Eigen::Vector3d& u,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& v) {
  constexpr double kFlattestPair = 1e-3; // sine squared: parallel rays say nothing
  const Eigen::Vector3d normal = u.cross(v);
  const double square = normal.squaredNorm();
  if (square < kFlattestPair) {
    return std::nullopt;
  }
  const Eigen::Vector3d apart = b - a;
  const double alongU = apart.cross(v).dot(normal) / square;
  const double alongV = apart.cross(u).dot(normal) / square;
  return Passing{0.5 * (a + alongU * u + b + alongV * v), apart.dot(normal) / std::sqrt(square)};
}

/// Median of what the gaps are off a polynomial of the place, meters.
double unexplained(const std::vector<Passing>& samples) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Passing& one : samples) {
    middle += one.middle / static_cast<double>(count);
  }
  Eigen::MatrixXd terms(count, kTerms);
  Eigen::VectorXd gaps(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Passing& one = samples[static_cast<std::size_t>(i)];
    const Eigen::Vector3d at = one.middle - middle;
    terms.row(i) << 1.0, at.x(), at.y(), at.z(), at.x() * at.x(), at.y() * at.y(), at.z() * at.z(),
        at.x() * at.y(), at.y() * at.z(), at.z() * at.x();
    gaps[i] = one.gap;
  }
  const Eigen::VectorXd left = gaps - terms * geometry::leastSquares(terms, gaps);
  std::vector<double> sizes(static_cast<std::size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    sizes[static_cast<std::size_t>(i)] = std::abs(left[i]);
  }
  return upperMedian(std::move(sizes)) / std::sqrt(1.0 - kTerms / static_cast<double>(count));
}

/// One camera's tracks against another's: ball by ball.
using Tracks = std::array<Track, 2>;

/// How two cameras' rays pass if the second one's views are shifted by so many seconds.
std::vector<Passing> passingsAt(const Tracks& reference, const Tracks& other, double shift,
                                double longestGap) {
  std::vector<Passing> samples;
  for (std::size_t ball = 0; ball < reference.size(); ++ball) {
    const auto& directions = reference[ball].directions;
    const std::size_t stride = directions.size() / kMostSamples + 1;
    for (std::size_t i = 0; i < directions.size(); i += stride) {
      const auto direction = directionAt(other[ball], directions[i].time - shift, longestGap);
      const auto sample = direction ? passing(reference[ball].center, directions[i].direction,
                                              other[ball].center, *direction)
                                    : std::nullopt;
      if (sample) {
        samples.push_back(*sample);
      }
    }
  }
  return samples;
}

double offsetBetween(const Tracks& reference, const Tracks& other) {
  const double period = std::max(periodOf(reference[0]), periodOf(other[0]));
  const auto still = passingsAt(reference, other, 0.0, kLongestGap * period);
  if (!(period > 0.0) || still.size() < kFewestSamples) {
    return 0.0;
  }
  const auto fewest = static_cast<std::size_t>(kFewestShare * static_cast<double>(still.size()));
  const int steps = static_cast<int>(kMost / (kOffsetStep * period));
  double best = 0.0;
  double least = kClearGain * unexplained(still);
  for (int step = -steps; step <= steps; ++step) {
    const double shift = step * kOffsetStep * period;
    const auto samples = passingsAt(reference, other, shift, kLongestGap * period);
    if (samples.size() < std::max(fewest, kFewestSamples)) {
      continue;
    }
    if (const double left = unexplained(samples); left < least) {
      least = left;
      best = shift;
    }
  }
  return best;
}

/// Instants at which both saw a ball, roughly.
std::size_t shared(const Tracks& a, const Tracks& b) {
  std::size_t count = 0;
  for (std::size_t ball = 0; ball < a.size(); ++ball) {
    const double gap = kLongestGap * std::max(periodOf(a[ball]), periodOf(b[ball]));
    count += static_cast<std::size_t>(
        std::ranges::count_if(a[ball].directions, [&](const TimedDirection& seen) {
          return directionAt(b[ball], seen.time, gap).has_value();
        }));
  }
  return count;
}

} // namespace

std::vector<double> searchTimeOffsets(const WandProblem& problem) {
  const std::size_t count = problem.initialRig.size();
  std::vector<Tracks> tracks;
  for (std::size_t c = 0; c < count; ++c) {
    tracks.push_back({trackOf(problem, c, 0), trackOf(problem, c, 1)});
  }
  std::vector<double> offsets(count, 0.0);
  std::vector<bool> known(count, false);
  known.front() = true;
  for (std::size_t round = 1; round < count; ++round) {
    // Next the camera that shares most with one whose offset is known.
    std::size_t most = 0;
    std::array<std::size_t, 2> pair{};
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; known[a] && b < count; ++b) {
        if (const std::size_t common = known[b] ? 0 : shared(tracks[a], tracks[b]); common > most) {
          most = common;
          pair = {a, b};
        }
      }
    }
    if (most == 0) {
      break;
    }
    const auto [reference, other] = pair;
    offsets[other] = offsets[reference] + offsetBetween(tracks[reference], tracks[other]);
    known[other] = true;
  }
  return offsets;
}

std::vector<std::vector<MarkerObservation>>
shiftedInTime(std::vector<std::vector<MarkerObservation>> views,
              const std::vector<double>& offsets) {
  for (std::size_t c = 0; c < std::min(views.size(), offsets.size()); ++c) {
    for (MarkerObservation& view : views[c]) {
      view.time += offsets[c];
    }
  }
  return views;
}

} // namespace dewpoint::calibration
