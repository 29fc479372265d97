// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/clock_estimator.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/time_budget.h"
#include "core/tracking/dewpoint/tracked_objects.h"

#include <cstddef>

namespace dewpoint::tracking {

/// Measurement update, which updates the tracks of all targets and distractors with the images of a
/// frame. Each object is treated as a ball or as an object of any shape.
class ObjectUpdate {
public:
  /// Inputs of an update. The references must stay valid as long as the ObjectUpdate exists.
  struct Context {
    TrackedObjects& objects;
    FrameImages& images;
    const ClockEstimator& clocks;
    const CandidateSearch& candidates;
    TimeBudget& budget;
    RandomKey key; ///< key of the random numbers of the run in this iteration
  };

  ObjectUpdate(const Context& context, ThreadTeam& team) : in_(context), team_(team) {}

  /// Updates all tracks, starting with the most probable object. Afterward, no two objects are at
  /// one position.
  void updateAllObjects();

private:
  void update(std::size_t index);
  /// Sets the capture times of the images for the image rows that show an object.
  void alignTimesFor(const TrackedObject& object);
  void updateAsBall(std::size_t index);
  /// Learns the shape of a target, and updates the track of a target that is not a ball.
  void updateShape(std::size_t target);

  Context in_;
  ThreadTeam& team_;
};

} // namespace dewpoint::tracking
