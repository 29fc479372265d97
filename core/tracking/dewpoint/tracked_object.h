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

/// Target or distractor (another object that looks like a target).
struct TrackedObject {
  BernoulliTrack track;
  SphereObservation observation;
  AdaptiveColor color;
  /// Search for the object that is spread over several frames because of the time budget; null if
  /// no such search is in progress.
  std::unique_ptr<SlicedSearch> search;
  /// Separates the random numbers of this object from those of others.
  std::uint32_t randomStreamId = 0;
  int unseenFrameCount = 0; ///< number of frames since the object was last tracked
  /// What is known about the shape of the target. Null for distractors, which are assumed to be
  /// balls.
  std::unique_ptr<ShapeTracking> shapeTracking = nullptr;
  double secondsSinceTracked = 0.0; ///< time in seconds since the object was last tracked

  /// Returns whether the object is assumed to be a ball.
  bool isBall() const { return !shapeTracking || shapeTracking->belief().isBall(); }

  /// Returns the key of the object's random numbers. `run` is the key of the run in the same frame
  /// and iteration.
  RandomKey randomKey(const RandomKey& run) const {
    return {derivedSeed(run.seed, randomStreamId), run.frame, run.iteration};
  }
};

/// Returns whether the targets of two objects have the same colors.
inline bool haveSameColor(const TrackedObject& one, const TrackedObject& other) {
  return one.track.target().colors() == other.track.target().colors();
}

} // namespace dewpoint::tracking
