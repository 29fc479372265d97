// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/tracked_objects.h"

#include "core/observation/sphere/sphere_evidence.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, sections 2 and 7).

/// Pixels beyond SphereEvidence::kOutlineMargin that still belong to an outline's blurred rim.
constexpr double kOutlineMarginPx = 1.0;
/// Probability of a target that counts as certain. Origin not recorded.
constexpr double kCertainProbability = 0.9;

bool overlap(const TrackHypothesis& a, const TrackHypothesis& b) {
  return (a.position() - b.position()).norm() <= kTouching * (a.radius + b.radius);
}

bool isMostlyVisible(const TrackHypothesis& hypothesis) {
  return hypothesis.logLikelihoodRatio >
         TrackHypothesis::kMostlyVisibleShare * hypothesis.fullyVisibleLogLikelihoodRatio;
}

} // namespace

TrackedObjects::TrackedObjects(const std::vector<Target>& targets, const CameraRig& rig)
    : rig_(rig), targetCount_(targets.size()) {
  for (const Target& target : targets) {
    objects_.push_back({BernoulliTrack(target), SphereObservation(rig),
                        AdaptiveColor(target.colors(), rig.size()), nullptr,
                        static_cast<std::uint32_t>(objects_.size()), 0,
                        std::make_unique<ShapeTracking>(target, rig)});
  }
}

TrackedObjects::TrackedObjects(const TrackedObjects& other)
    : rig_(other.rig_), targetCount_(other.targetCount_) {
  for (const TrackedObject& object : other.objects_) {
    objects_.push_back({object.track, SphereObservation(rig_), object.color, nullptr,
                        object.randomStreamId, object.unseenFrameCount,
                        object.shapeTracking
                            ? std::make_unique<ShapeTracking>(*object.shapeTracking, rig_)
                            : nullptr,
                        object.secondsSinceTracked});
  }
}

void TrackedObjects::setCameras(const CameraRig& rig) {
  rig_ = rig;
  for (TrackedObject& object : objects_) {
    object.observation = SphereObservation(rig);
    object.search.reset();
    if (object.shapeTracking) {
      object.shapeTracking->setCameras(rig);
    }
  }
}

TrackedObject TrackedObjects::makeDistractorProbe(std::size_t target,
                                                  const BernoulliTrackSettings& settings) const {
  TrackedObject probe{BernoulliTrack(objects_[target].track.target()), SphereObservation(rig_),
                      objects_[target].color, nullptr};
  probe.track.configure(settings);
  probe.track.setCreatesHypotheses(false);
  return probe;
}

TrackedObject& TrackedObjects::addDistractor(TrackedObject distractor) {
  objects_.push_back(std::move(distractor));
  return objects_.back();
}

void TrackedObjects::removeDistractor(std::size_t index) {
  objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(index));
}

void TrackedObjects::removeDistractors() {
  objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(targetCount_), objects_.end());
}

void TrackedObjects::removeDistractorsOf(std::size_t target) {
  for (std::size_t k = objects_.size(); k-- > targetCount_;) {
    if (haveSameColor(objects_[k], objects_[target])) {
      removeDistractor(k);
    }
  }
}

std::vector<std::size_t> TrackedObjects::indicesByProbability() const {
  std::vector<std::size_t> order(objects_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto probability = [&](std::size_t k) {
    const TrackHypothesis* best = objects_[k].track.mostLikelyHypothesis();
    return best != nullptr ? best->probability : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probability(a) > probability(b); });
  return order;
}

std::vector<OccupiedSphere> TrackedObjects::spheresOfOthers(std::size_t index) const {
  std::vector<OccupiedSphere> occupied;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const TrackHypothesis* other = k != index ? objects_[k].track.confidentHypothesis() : nullptr;
    if (other != nullptr) {
      occupied.push_back({other->position(), other->radius});
    }
  }
  return occupied;
}

std::vector<OccupiedSphere> TrackedObjects::spheresOfOtherTargets(std::size_t index) const {
  std::vector<OccupiedSphere> occupied;
  for (std::size_t k = 0; k < targetCount_; ++k) {
    const TrackHypothesis* other = k != index ? objects_[k].track.confidentHypothesis() : nullptr;
    if (other != nullptr) {
      occupied.push_back({other->position(), other->radius});
    }
  }
  return occupied;
}

bool TrackedObjects::mayHaveDistractors(std::size_t target) const {
  return std::all_of(objects_.begin(), objects_.begin() + static_cast<std::ptrdiff_t>(targetCount_),
                     [&](const TrackedObject& other) {
                       return other.isBall() || !haveSameColor(other, objects_[target]);
                     });
}

bool TrackedObjects::isFirstOfItsColor(std::size_t target) const {
  return std::none_of(
      objects_.begin(), objects_.begin() + static_cast<std::ptrdiff_t>(target),
      [&](const TrackedObject& other) { return haveSameColor(other, objects_[target]); });
}

bool TrackedObjects::hasIdenticalTarget(std::size_t target) const {
  const Target& own = objects_[target].track.target();
  for (std::size_t k = 0; k < targetCount_; ++k) {
    const Target& other = objects_[k].track.target();
    if (k != target && other.colors() == own.colors() && other.radius == own.radius) {
      return true;
    }
  }
  return false;
}

bool TrackedObjects::areAllTargetsVisible() const {
  return std::all_of(objects_.begin(), objects_.begin() + static_cast<std::ptrdiff_t>(targetCount_),
                     [](const TrackedObject& object) {
                       const TrackHypothesis* best = object.track.mostLikelyHypothesis();
                       return best != nullptr && best->probability > kCertainProbability &&
                              isMostlyVisible(*best);
                     });
}

void TrackedObjects::markPixelsOfOthers(SphereObservation& observation,
                                        const TrackedObject& own) const {
  const TrackHypothesis* mine = own.track.confidentHypothesis();
  for (const TrackedObject& object : objects_) {
    const TrackHypothesis* other = &object != &own ? object.track.confidentHypothesis() : nullptr;
    // Only an object that is mostly visible itself explains anything.
    const bool explains = other != nullptr && other->wasOutlineFound && isMostlyVisible(*other) &&
                          haveSameColor(object, own);
    for (std::size_t camera = 0; explains && camera < observation.cameraCount(); ++camera) {
      LabelImage& labels = observation.labels(camera);
      const SphereProjector& projector = observation.projector(camera);
      const auto outline = projector.project(other->position(), other->radius);
      if (labels.empty() || !outline) {
        continue;
      }
      // The part of `own` that lies in front of the other remains its own.
      LabelImage::Circle kept;
      const auto ownOutline =
          mine != nullptr ? projector.project(mine->position(), mine->radius) : std::nullopt;
      if (ownOutline && projector.depth(mine->position()) < projector.depth(other->position())) {
        kept = {ownOutline->center, SphereEvidence::kOutlineMargin * ownOutline->radius};
      }
      labels.markExplained(
          {outline->center, SphereEvidence::kOutlineMargin * outline->radius + kOutlineMarginPx},
          kept);
    }
  }
}

void TrackedObjects::markPixelsOfOtherTargets(std::size_t target) {
  const TrackedObject& own = objects_[target];
  for (std::size_t k = 0; k < targetCount_; ++k) {
    const TrackHypothesis* other = k != target ? objects_[k].track.confidentHypothesis() : nullptr;
    if (other == nullptr || !other->wasOutlineFound || !isMostlyVisible(*other) ||
        !haveSameColor(objects_[k], own)) {
      continue;
    }
    for (std::size_t camera = 0; camera < own.observation.cameraCount(); ++camera) {
      LabelImage& labels = own.shapeTracking->observation().views()[camera].labels;
      const auto outline =
          own.observation.projector(camera).project(other->position(), other->radius);
      if (!labels.empty() && outline) {
        labels.markExplained(
            {outline->center, SphereEvidence::kOutlineMargin * outline->radius + kOutlineMarginPx},
            {});
      }
    }
  }
}

std::unique_ptr<SlicedSearch> TrackedObjects::startSearch(const TrackedObject& own,
                                                          const FrameImages& images) const {
  auto search = std::make_unique<SlicedSearch>(rig_, own.color, own.track.target().radius,
                                               images.frames(), own.track.bounds());
  images.passImagesTo(search->observation(), search->color());
  markPixelsOfOthers(search->observation(), own);
  return search;
}

void TrackedObjects::suppressIfAtTarget(std::size_t distractor) {
  BernoulliTrack& track = objects_[distractor].track;
  const TrackHypothesis* own = track.confidentHypothesis();
  for (std::size_t k = 0; k < targetCount_ && own != nullptr; ++k) {
    const TrackHypothesis* target = objects_[k].track.confidentHypothesis();
    // A target that was clearly visible a frame ago is still there. (The estimate of a hidden one
    // may be wrong.)
    if (target != nullptr && target->isSaturated() && overlap(*own, *target)) {
      track.suppressBestHypothesis();
      own = nullptr;
    }
  }
}

std::vector<std::size_t> TrackedObjects::removeOthersAtPositionOf(std::size_t target) {
  const TrackHypothesis* const own = objects_[target].track.mostLikelyHypothesis();
  std::vector<std::size_t> changed;
  for (std::size_t k = objects_.size(); own->wasOutlineFound && k-- > 0;) {
    const TrackHypothesis* const other = objects_[k].track.confidentHypothesis();
    if (k == target || other == nullptr || !overlap(*own, *other)) {
      continue;
    }
    if (k >= targetCount_) {
      removeDistractor(k);
    } else {
      objects_[k].track.suppressBestHypothesis();
      objects_[k].track.removeOccupied({{own->position(), own->radius}});
      changed.push_back(k);
    }
  }
  return changed;
}

void TrackedObjects::resolveConflicts() {
  for (std::size_t a = 0; a < objects_.size(); ++a) {
    for (std::size_t b = a + 1; b < objects_.size(); ++b) {
      const TrackHypothesis* first = objects_[a].track.confidentHypothesis();
      const TrackHypothesis* second = objects_[b].track.confidentHypothesis();
      if (first == nullptr || second == nullptr || !overlap(*first, *second)) {
        continue;
      }
      (first->logLikelihoodRatio >= second->logLikelihoodRatio ? objects_[b] : objects_[a])
          .track.suppressBestHypothesis();
    }
  }
}

void TrackedObjects::resolveIdentities() {
  for (std::size_t k = 0; k < targetCount_; ++k) {
    objects_[k].track.removeOccupied(spheresOfOthers(k));
    objects_[k].track.resolveIdentity(hasIdenticalTarget(k));
  }
}

} // namespace dewpoint::tracking
