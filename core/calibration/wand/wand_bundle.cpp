// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/wand/wand_bundle.h"

#include "core/base/statistics.h"
#include "core/geometry/sphere_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

constexpr std::size_t kRun = 30; ///< states that stay together when a path is thinned

struct TimedView {
  std::size_t camera;
  const MarkerObservation* view;
};

/// All views, rising in time; the camera breaks ties, so the order is the same every time.
std::vector<TimedView> viewsInTime(const WandProblem& problem) {
  std::vector<TimedView> all;
  for (std::size_t c = 0; c < problem.views.size(); ++c) {
    for (const MarkerObservation& view : problem.views[c]) {
      all.push_back({c, &view});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const TimedView& a, const TimedView& b) {
    return a.view->time < b.view->time;
  });
  return all;
}

/// The usual time between two images of one camera, seconds.
double usualPeriod(const WandProblem& problem) {
  std::vector<double> gaps;
  for (const auto& views : problem.views) {
    for (std::size_t i = 1; i < views.size(); ++i) {
      if (const double gap = views[i].time - views[i - 1].time; gap > 1e-6) {
        gaps.push_back(gap);
      }
    }
  }
  return upperMedian(std::move(gaps));
}

} // namespace

Status checkViews(const WandProblem& problem) {
  if (problem.initialRig.size() < 2) {
    return failure(ErrorCode::Undetermined, "", "cameras", "at least two are needed");
  }
  if (problem.views.size() != problem.initialRig.size()) {
    return failure(ErrorCode::Mismatch, "", "views", "one list per camera is needed");
  }
  for (std::size_t c = 0; c < problem.views.size(); ++c) {
    if (problem.views[c].empty()) {
      return failure(ErrorCode::Undetermined, "", problem.initialRig[c].name,
                     "the target was not found in any of its images");
    }
    for (const MarkerObservation& view : problem.views[c]) {
      if (!view.pixel.allFinite() || !std::isfinite(view.time) || !(view.sigma > 0.0) ||
          view.ball > 1) {
        return failure(ErrorCode::BadValue, "", problem.initialRig[c].name,
                       "a view has no usable time, position or sigma");
      }
    }
  }
  for (std::size_t ball = 0; problem.stickLength > 0.0 && ball < 2; ++ball) {
    const bool seen = std::ranges::any_of(problem.views, [ball](const auto& views) {
      return std::ranges::any_of(
          views, [ball](const MarkerObservation& view) { return view.ball == ball; });
    });
    if (!seen) {
      return failure(
          ErrorCode::Undetermined, "", "stick",
          fmt::format("the {} ball of the wand was found in no image: learn its color first",
                      ball == 0 ? "first" : "second"));
    }
  }
  return {};
}

Result<BundleProblem> makeWandBundle(const WandProblem& problem) {
  if (auto usable = checkViews(problem); !usable) {
    return tl::make_unexpected(usable.error());
  }
  const bool stick = problem.stickLength > 0.0;
  BundleProblem bundle;
  for (const Camera& camera : problem.initialRig) {
    bundle.cameras.push_back({.camera = camera});
  }
  bundle.bodies.push_back({.name = stick ? "stick" : "ball",
                           .kind = stick ? BundleBody::Kind::Stick : BundleBody::Kind::Point,
                           .length = problem.stickLength});
  const double period = usualPeriod(problem);
  bundle.maxStateGapSeconds = 2.5 * period;
  const double reach = problem.initialRig.size() > 1 ? 0.5 * period : 0.0;
  std::vector<bool> taken; // by (camera, ball), within the present state
  for (const auto& [camera, view] : viewsInTime(problem)) {
    if (view->ball > 0 && !stick) {
      continue;
    }
    const std::size_t slot = 2 * camera + view->ball;
    if (bundle.states.empty() || view->time > bundle.states.back().time + reach || taken.at(slot)) {
      bundle.states.push_back({.body = 0, .time = view->time});
      taken.assign(2 * problem.initialRig.size(), false);
    }
    taken[slot] = true;
    bundle.observations.push_back({.camera = camera,
                                   .state = bundle.states.size() - 1,
                                   .point = view->ball,
                                   .pixel = view->pixel,
                                   .sigma = view->sigma,
                                   .timeAfterState = view->time - bundle.states.back().time,
                                   .radius = view->radius});
  }
  return bundle;
}

BundleProblem subsampledBundle(const BundleProblem& problem, int most, bool inRuns) {
  const std::size_t run = inRuns ? kRun : 1;
  const std::size_t runs = (problem.states.size() + run - 1) / run;
  const std::size_t kept = std::max<std::size_t>(1, static_cast<std::size_t>(most) / run);
  if (runs <= kept) {
    return problem;
  }
  BundleProblem fewer = problem;
  fewer.states.clear();
  fewer.observations.clear();
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> renamed(problem.states.size(), kNone);
  for (std::size_t s = 0; s < problem.states.size(); ++s) {
    const std::size_t r = s / run;
    // Run r is kept when a multiple of runs/kept falls into it.
    if ((r * kept + runs - 1) / runs * runs < (r + 1) * kept) {
      renamed[s] = fewer.states.size();
      fewer.states.push_back(problem.states[s]);
    }
  }
  for (BundleObservation seen : problem.observations) {
    if (renamed[seen.state] != kNone) {
      seen.state = renamed[seen.state];
      fewer.observations.push_back(seen);
    }
  }
  return fewer;
}

void updateOutlineShifts(const std::array<double, 2>& ballRadii, const BundleResult& now,
                         BundleProblem& problem) {
  std::vector<SphereProjector> projectors;
  for (const Camera& camera : now.cameras) {
    projectors.emplace_back(camera);
  }
  for (BundleObservation& seen : problem.observations) {
    const BundleState& state = now.states[seen.state];
    const double radius = ballRadii[seen.point];
    if (!state.isPositionKnown || !(radius > 0.0)) {
      continue;
    }
    const double ratio = radius / projectors[seen.camera].depth(state.ends[seen.point]);
    seen.outlineShift = ratio > 0.0 && ratio < 0.5 ? ratio * ratio : 0.0;
  }
}

std::size_t dropWorstObservations(const BundleResult& now, double limit, BundleProblem& problem,
                                  std::vector<std::size_t>& dropped) {
  const std::size_t count = problem.observations.size();
  std::vector<std::size_t> worst(problem.states.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const double off = now.residuals[i].norm(); // NaN where it was not used: then not compared
    std::size_t& other = worst[problem.observations[i].state];
    if (off > limit && (other == count || off > now.residuals[other].norm())) {
      other = i;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const BundleObservation seen = problem.observations[i];
    if (worst[seen.state] == i) {
      ++dropped[seen.camera];
    } else {
      problem.observations[kept++] = seen;
    }
  }
  problem.observations.resize(kept);
  return count - kept;
}

double medianResidual(const BundleProblem& problem, const BundleResult& now, int camera) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    const double length = now.residuals[i].norm();
    if (std::isfinite(length) &&
        (camera < 0 || problem.observations[i].camera == static_cast<std::size_t>(camera))) {
      lengths.push_back(length);
    }
  }
  return upperMedian(std::move(lengths));
}

} // namespace dewpoint::calibration
