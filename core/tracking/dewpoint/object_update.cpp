// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/object_update.h"

namespace dewpoint::tracking {

void ObjectUpdate::updateAllObjects() {
  for (std::size_t k = in_.objects.targetCount(); k < in_.objects.size(); ++k) {
    in_.objects.suppressIfAtTarget(k);
  }
  for (const std::size_t k : in_.objects.indicesByProbability()) {
    update(k);
  }
  for (std::size_t k = 0; k < in_.objects.targetCount(); ++k) {
    if (!in_.objects[k].isBall()) {
      in_.objects.removeDistractorsOf(k); // they were parts of it
    }
  }
  in_.objects.resolveConflicts();
}

void ObjectUpdate::update(std::size_t index) {
  if (in_.objects[index].isBall()) {
    updateAsBall(index);
  }
  if (index < in_.objects.targetCount()) {
    updateShape(index);
  }
}

void ObjectUpdate::updateShape(std::size_t target) {
  TrackedObject& object = in_.objects[target];
  ShapeTracking& shape = *object.shapeTracking;
  const bool wasBall = object.isBall();
  const TrackHypothesis* const ball = wasBall ? object.track.confidentHypothesis() : nullptr;
  if (wasBall && !shape.needsImages(ball != nullptr)) {
    return;
  }
  alignTimesFor(object);
  if (!wasBall) { // what was shown there is older
    in_.images.passImagesTo(object.observation, object.color);
  }
  in_.images.passImagesTo(shape.observation(), object.color);
  in_.objects.markPixelsOfOtherTargets(target);
  if (ball != nullptr) {
    shape.measureBall(*ball, object.randomKey(in_.key), team_);
  } else {
    shape.update(in_.objects.spheresOfOtherTargets(target), object.randomKey(in_.key), team_);
  }
  const TrackHypothesis* const other = shape.track().hypothesis();
  if (!object.isBall()) {
    object.search.reset();
    object.track.setOnlyHypothesis(other);
  } else if (!wasBall && other != nullptr) {
    object.track.initializeAt(other->position(), other->radius, object.observation,
                              object.randomKey(in_.key), team_);
  }
}

void ObjectUpdate::alignTimesFor(const TrackedObject& object) {
  const TrackHypothesis* const expected = object.track.mostLikelyHypothesis();
  in_.images.setDelays(expected != nullptr ? in_.clocks.delaysAt(expected->position())
                                           : in_.clocks.delays());
}

void ObjectUpdate::updateAsBall(std::size_t index) {
  TrackedObject& object = in_.objects[index];
  alignTimesFor(object);
  in_.images.passImagesTo(object.observation, object.color);
  in_.objects.markPixelsOfOthers(object.observation, object);
  const auto findNow = [&](SphereObservation& observation, bool radiusKnown, std::size_t limit) {
    return in_.candidates.find(observation, radiusKnown, limit, object.track.bounds());
  };
  bool searched = false;
  const auto findInSlices = [&](SphereObservation&, bool, std::size_t limit) {
    searched = true;
    if (!object.search) {
      object.search = in_.objects.startSearch(object, in_.images);
    }
    return advanceSearch(object.search, in_.candidates, in_.budget, limit, true);
  };
  const CandidateSource search =
      in_.budget.isLimited() ? CandidateSource(findInSlices) : CandidateSource(findNow);
  object.track.update(object.observation, search, in_.objects.spheresOfOthers(index),
                      object.randomKey(in_.key), team_);
  if (!searched) {
    object.search.reset(); // candidates in old images are of no use later
  }
  if (index >= in_.objects.targetCount()) {
    in_.objects.suppressIfAtTarget(index);
  }
}

} // namespace dewpoint::tracking
