// SPDX-License-Identifier: GPL-3.0-or-later
// How a DewpointTracker finds things that look like its targets.
#include "core/tracking/dewpoint/dewpoint_tracker.h"

#include <algorithm>

namespace dewpoint::tracking {
namespace {

/// Look-alikes are looked for every so many frames, soon after the start for the first time.
constexpr std::int64_t kDistractorSearchPeriod = 4;
constexpr std::int64_t kDistractorSearchPhase = 1;
constexpr std::size_t kMaxDistractors = 8;
/// Evidence, as a share of the best, that makes a thing a look-alike.
constexpr double kDistractorShare = 0.6;
constexpr double kCertainProbability = 0.9;
constexpr int kGraceUpdates = 3;
/// Within a budget so many places of a search are looked at: each costs an outline fit.
constexpr std::size_t kMaxCandidatesOnBudget = 4;

} // namespace

bool DewpointTracker::allTargetsSure() const {
  return std::all_of(tracked_.begin(), tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_),
                     [](const Tracked& tracked) {
                       const TrackHypothesis* best = tracked.belief.best();
                       return best != nullptr && best->probability > kCertainProbability &&
                              best->logLikelihoodRatio > TrackHypothesis::kMostlyVisibleShare *
                                                             best->fullyVisibleLogLikelihoodRatio;
                     });
}

void DewpointTracker::forgetLostLookAlikes() {
  for (std::size_t k = tracked_.size(); k-- > targetCount_;) {
    const TrackHypothesis* seen = tracked_[k].belief.confident();
    const bool faint = seen != nullptr && seen->updateCount > kGraceUpdates &&
                       seen->logLikelihoodRatio < TrackHypothesis::kPartlyVisibleShare *
                                                      seen->fullyVisibleLogLikelihoodRatio;
    if (seen == nullptr || faint) {
      tracked_.erase(tracked_.begin() + static_cast<std::ptrdiff_t>(k));
      streams_.erase(streams_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

bool DewpointTracker::hasTwins(std::size_t target) const {
  const Target& own = tracked_[target].belief.target();
  for (std::size_t k = 0; k < targetCount_; ++k) {
    const Target& other = tracked_[k].belief.target();
    if (k != target && other.color == own.color && other.radius == own.radius) {
      return true;
    }
  }
  return false;
}

void DewpointTracker::watchLookAlikes(ThreadTeam& team) {
  forgetLostLookAlikes();
  for (std::size_t k = 0; k < targetCount_; ++k) {
    tracked_[k].belief.removeOccupied(occupiedByOthers(k));
    tracked_[k].belief.resolveIdentity(hasTwins(k));
  }
  if (budget_.limited()) {
    lookAroundInSlices(team);
    return;
  }
  if (frameCount_ % kDistractorSearchPeriod != kDistractorSearchPhase || targetCount_ == 0 ||
      !allTargetsSure()) {
    return;
  }
  for (std::size_t k = 0; k < targetCount_; ++k) {
    if (isFirstOfItsColor(k)) {
      findLookAlikes(k, team);
    }
  }
}

bool DewpointTracker::isFirstOfItsColor(std::size_t target) const {
  return std::none_of(tracked_.begin(), tracked_.begin() + static_cast<std::ptrdiff_t>(target),
                      [&](const Tracked& other) {
                        return other.belief.target().color ==
                               tracked_[target].belief.target().color;
                      });
}

DewpointTracker::Tracked DewpointTracker::thingLike(std::size_t target) const {
  Tracked thing{BernoulliTrack(tracked_[target].belief.target()), SphereObservation(rig_),
                tracked_[target].color, nullptr};
  thing.belief.configure(settings());
  thing.belief.setBirths(false);
  return thing;
}

bool DewpointTracker::isNewLookAlike(const Candidate& candidate, SphereObservation& observation,
                                     double logLikelihoodRatio) const {
  observation.setRadius(candidate.radius);
  const double best =
      observation.fullyVisibleLogLikelihoodRatio(candidate.center, Eigen::Vector3d::Zero());
  const auto occupied = occupiedByOthers(tracked_.size());
  const bool taken = std::any_of(occupied.begin(), occupied.end(), [&](const auto& sphere) {
    return (sphere.center - candidate.center).norm() < sphere.radius + candidate.radius;
  });
  return !taken && logLikelihoodRatio >= kDistractorShare * best;
}

void DewpointTracker::addLookAlike(Tracked thing, const Candidate& place, ThreadTeam& team) {
  streams_.push_back(nextLookAlike_++);
  tracked_.push_back(std::move(thing));
  Tracked& added = tracked_.back();
  showImages(added.observation, added.color); // without what the search had explained by others
  added.belief.initializeAt(place.center, place.radius, added.observation,
                            keyOf(tracked_.size() - 1), team);
}

void DewpointTracker::findLookAlikes(std::size_t target, ThreadTeam& team) {
  if (tracked_.size() >= targetCount_ + kMaxDistractors) {
    return;
  }
  const double radius = tracked_[target].belief.target().radius;
  Tracked probe = thingLike(target);
  showImages(probe.observation, probe.color);
  explainOthers(probe.observation, probe); // else two things seen crosswise would make a third
  probe.observation.setRadius(radius);
  for (const Candidate& candidate :
       search_.find(probe.observation, radius > 0.0, kMaxDistractors)) {
    if (isNewLookAlike(candidate, probe.observation, candidate.logLikelihoodRatio)) {
      addLookAlike(std::move(probe), candidate, team);
      return; // one at a time
    }
  }
}

std::unique_ptr<SlicedSearch> DewpointTracker::beginSearch(const Tracked& own) {
  auto search =
      std::make_unique<SlicedSearch>(rig_, own.color, own.belief.target().radius, frames_);
  showImages(search->observation(), search->color());
  explainOthers(search->observation(), own);
  return search;
}

std::vector<Candidate> DewpointTracker::goOn(std::unique_ptr<SlicedSearch>& search,
                                             std::size_t limit, bool urgent) {
  if (!search->advance(search_, budget_, std::min(limit, kMaxCandidatesOnBudget), urgent)) {
    return {};
  }
  auto places = search->places();
  search.reset();
  return places;
}

void DewpointTracker::lookAroundInSlices(ThreadTeam& team) {
  const bool full = tracked_.size() >= targetCount_ + kMaxDistractors;
  if (full || targetCount_ == 0 || !allTargetsSure()) {
    lookAround_.reset();
    return;
  }
  if (!lookAround_) {
    if (frameCount_ < nextLookAround_) {
      return;
    }
    nextLookAround_ = frameCount_ + kDistractorSearchPeriod;
    do { // the next target, of those that do not share their color with an earlier one
      lookAroundFor_ = (lookAroundFor_ + 1) % targetCount_;
    } while (!isFirstOfItsColor(lookAroundFor_));
    lookAround_ = beginSearch(thingLike(lookAroundFor_));
  }
  const auto places = goOn(lookAround_, kMaxDistractors, false);
  if (places.empty()) {
    return;
  }
  // The places are some frames old: where are they now?
  Tracked probe = thingLike(lookAroundFor_);
  showImages(probe.observation, probe.color);
  explainOthers(probe.observation, probe);
  for (Candidate place : places) {
    OutlinePrior prior;
    prior.center = place.center;
    prior.radius = place.radius;
    prior.information = Eigen::Matrix3d::Identity() / (place.radius * place.radius);
    const OutlineFit fit = probe.observation.fit(prior, Eigen::Vector3d::Zero());
    place.center = fit.found ? fit.center : place.center;
    probe.observation.setRadius(place.radius);
    const double now = probe.observation.logLikelihoodRatio(place.center, Eigen::Vector3d::Zero());
    if (isNewLookAlike(place, probe.observation, now)) {
      addLookAlike(std::move(probe), place, team);
      return;
    }
  }
}

} // namespace dewpoint::tracking
