// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_filter.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/search/sliced_search.h"
#include "core/tracking/dewpoint/shape_tracking.h"
#include "core/tracking/dewpoint/track/bernoulli_track.h"

#include <cstdint>
#include <memory>

namespace dewpoint::tracking {

/// A target, or a distractor: an object that looks like one.
struct TrackedObject {
  BernoulliTrack track;
  SphereObservation observation;
  AdaptiveColor color;
  std::unique_ptr<SlicedSearch> search; ///< under way within a time budget; else null
  std::uint32_t stream = 0;             ///< keeps its random numbers apart from those of others
  int unseenFrames = 0;                 ///< since it was tracked last
  std::unique_ptr<ShapeTracking> shape = nullptr; ///< null of distractors, which are balls
  double unseenSeconds = 0.0;                     ///< since it was tracked last

  /// Whether it is taken for a ball.
  bool isBall() const { return !shape || shape->belief().isBall(); }

  /// The key of its random numbers in a frame and an iteration of a run.
  RandomKey keyIn(const RandomKey& run) const {
    return {derivedSeed(run.seed, stream), run.frame, run.iteration};
  }
};

/// Whether two objects are told apart by nothing but their positions.
inline bool haveSameColor(const TrackedObject& one, const TrackedObject& other) {
  return one.track.target().colors() == other.track.target().colors();
}

} // namespace dewpoint::tracking
