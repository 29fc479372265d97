// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_start.h"

#include "core/geometry/ray.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr std::size_t kFewestOfCamera = 6; ///< observations of a camera that is not fully known
constexpr std::size_t kFewestOfBoard = 4;  ///< points that make a board's pose
/// States that a point between instants is interpolated from, at most ...
constexpr std::size_t kMostKnots = 5;
/// ... and at least.
constexpr std::size_t kFewestKnots = 3;

using Kind = BundleBody::Kind;

tl::unexpected<Error> wrong(const std::string& field, const std::string& detail) {
  return failure(ErrorCode::BadValue, "", field, detail);
}

std::size_t pointCount(const BundleBody& body) {
  return body.kind == Kind::Point ? 1 : body.kind == Kind::Stick ? 2 : body.points.size();
}

Status checkIndices(const BundleProblem& problem) {
  for (const BundleState& state : problem.states) {
    if (state.body >= problem.bodies.size() || !std::isfinite(state.time)) {
      return wrong("states", "a state has no body or no time");
    }
    if (problem.bodies[state.body].kind == Kind::Board && !state.isPositionKnown &&
        !state.isFixed) {
      return wrong(problem.bodies[state.body].name, "a board needs a pose to start from");
    }
  }
  for (const BundleObservation& seen : problem.observations) {
    if (seen.camera >= problem.cameras.size() || seen.state >= problem.states.size() ||
        seen.point >= pointCount(problem.bodies[problem.states[seen.state].body])) {
      return wrong("observations", "an observation has no camera, no state or no point");
    }
    if (!seen.pixel.allFinite() || !(seen.sigma > 0.0) || !std::isfinite(seen.timeAfterState)) {
      return wrong("observations", "a pixel or its sigma is not a number");
    }
  }
  return {};
}

/// Finds what is usable by dropping, round after round, what lost its support.
class SupportPruning {
public:
  explicit SupportPruning(const BundleProblem& problem) : problem_(problem) {
    start_.states = problem.states;
    start_.isStateUsed.assign(problem.states.size(), true);
    start_.isObservationUsed.assign(problem.observations.size(), true);
    start_.interpolationStates.resize(problem.observations.size());
    ofState_.resize(problem.states.size());
    for (std::size_t i = 0; i < problem.observations.size(); ++i) {
      ofState_[problem.observations[i].state].push_back(i);
    }
    for (const BundleCamera& camera : problem.cameras) {
      unprojectors_.emplace_back(camera.camera);
    }
  }

  Result<BundleStart> run() {
    for (std::size_t s = 0; s < start_.states.size(); ++s) {
      start_.isStateUsed[s] = supported(s) && placed(s);
    }
    for (bool changed = true; changed;) {
      chooseKnots();
      changed = dropUnsupported();
    }
    for (std::size_t i = 0; i < start_.isObservationUsed.size(); ++i) {
      start_.hasInterpolation = start_.hasInterpolation || (start_.isObservationUsed[i] &&
                                                            !start_.interpolationStates[i].empty());
    }
    return enough().map([&] { return std::move(start_); });
  }

private:
  const BundleBody& bodyOf(std::size_t state) const {
    return problem_.bodies[start_.states[state].body];
  }

  bool supported(std::size_t state) const {
    if (start_.states[state].isFixed) {
      return true;
    }
    const BundleBody& body = bodyOf(state);
    if (body.kind == Kind::Board) {
      std::set<std::size_t> points;
      for (const std::size_t i : ofState_[state]) {
        if (start_.isObservationUsed[i]) {
          points.insert(problem_.observations[i].point);
        }
      }
      return points.size() >= kFewestOfBoard;
    }
    for (std::size_t point = 0; point < pointCount(body); ++point) {
      std::set<std::size_t> cameras;
      for (const std::size_t i : ofState_[state]) {
        const BundleObservation& seen = problem_.observations[i];
        if (start_.isObservationUsed[i] && seen.point == point) {
          cameras.insert(seen.camera);
        }
      }
      if (cameras.size() < 2) {
        return false;
      }
    }
    return true;
  }

  /// Triangulates the free points of a state that has no start.
  bool placed(std::size_t state) {
    BundleState& there = start_.states[state];
    const BundleBody& body = bodyOf(state);
    if (there.isPositionKnown || there.isFixed || body.kind == Kind::Board) {
      return true;
    }
    for (std::size_t point = 0; point < pointCount(body); ++point) {
      std::vector<Ray> rays;
      for (const std::size_t i : ofState_[state]) {
        const BundleObservation& seen = problem_.observations[i];
        if (seen.point == point) {
          if (const auto ray = unprojectors_[seen.camera].ray(seen.pixel)) {
            rays.push_back(*ray);
          }
        }
      }
      const auto position = nearestPoint(rays);
      if (!position) {
        return false;
      }
      there.ends[point] = *position;
    }
    return true;
  }

  /// Whether a camera's images can be of other instants than the states.
  bool betweenInstants(const BundleObservation& seen) const {
    const BundleCamera& camera = problem_.cameras[seen.camera];
    return camera.isTimeOffsetFree || camera.timeOffset + seen.timeAfterState != 0.0;
  }

  void chooseKnots() {
    std::vector<std::vector<std::size_t>> paths(problem_.bodies.size());
    for (std::size_t s = 0; s < start_.states.size(); ++s) {
      if (start_.isStateUsed[s] && bodyOf(s).kind != Kind::Board) {
        paths[start_.states[s].body].push_back(s);
      }
    }
    std::vector<std::vector<std::size_t>> around(start_.states.size());
    for (std::vector<std::size_t>& path : paths) {
      std::stable_sort(path.begin(), path.end(), [&](std::size_t a, std::size_t b) {
        return start_.states[a].time < start_.states[b].time;
      });
      for (std::size_t k = 0; k < path.size(); ++k) {
        around[path[k]] = neighbors(path, k);
      }
    }
    for (std::size_t i = 0; i < problem_.observations.size(); ++i) {
      const BundleObservation& seen = problem_.observations[i];
      const bool used = start_.isObservationUsed[i] && start_.isStateUsed[seen.state];
      start_.isObservationUsed[i] = used;
      start_.interpolationStates[i].clear();
      if (used && betweenInstants(seen) && bodyOf(seen.state).kind != Kind::Board) {
        start_.interpolationStates[i] = around[seen.state];
        start_.isObservationUsed[i] = start_.interpolationStates[i].size() >= kFewestKnots;
      }
    }
  }

  /// The states around the k-th of a path, up to kMostKnots, without a long gap between them.
  std::vector<std::size_t> neighbors(const std::vector<std::size_t>& path, std::size_t k) const {
    const auto joined = [&](std::size_t early) {
      const double gap = start_.states[path[early + 1]].time - start_.states[path[early]].time;
      return gap > 0.0 && gap <= problem_.maxStateGapSeconds;
    };
    std::size_t first = k;
    std::size_t last = k;
    while (last - first + 1 < kMostKnots) {
      const bool before = first > 0 && joined(first - 1);
      const bool after = last + 1 < path.size() && joined(last);
      if (!before && !after) {
        break;
      }
      if (before && (!after || k - first <= last - k)) {
        --first;
      } else {
        ++last;
      }
    }
    return {path.begin() + std::ptrdiff_t(first), path.begin() + std::ptrdiff_t(last + 1)};
  }

  bool dropUnsupported() {
    bool changed = false;
    for (std::size_t s = 0; s < start_.states.size(); ++s) {
      if (start_.isStateUsed[s] && !supported(s)) {
        start_.isStateUsed[s] = false;
        changed = true;
      }
    }
    return changed;
  }

  Status enough() const {
    std::vector<std::size_t> counts(problem_.cameras.size(), 0);
    for (std::size_t i = 0; i < problem_.observations.size(); ++i) {
      counts[problem_.observations[i].camera] += start_.isObservationUsed[i] ? 1 : 0;
    }
    for (std::size_t c = 0; c < counts.size(); ++c) {
      const BundleCamera& camera = problem_.cameras[c];
      const bool known = camera.isPoseFixed || camera.posePrior;
      if (counts[c] < kFewestOfCamera && !known) {
        return failure(ErrorCode::Undetermined, "", camera.camera.name,
                       fmt::format("{} usable observations, at least {} are needed", counts[c],
                                   kFewestOfCamera));
      }
    }
    if (std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == 0) {
      return failure(ErrorCode::Undetermined, "", "observations", "none of them can be used");
    }
    return {};
  }

  const BundleProblem& problem_;
  BundleStart start_;
  std::vector<std::vector<std::size_t>> ofState_;
  std::vector<Unprojector> unprojectors_;
};

} // namespace

Result<BundleStart> initializeBundle(const BundleProblem& problem) {
  return checkIndices(problem).and_then([&] { return SupportPruning(problem).run(); });
}

} // namespace dewpoint::calibration
