// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/distractor_search.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 7).

/// Frames between two searches, and the frame of the first one.
constexpr std::int64_t kDistractorSearchPeriod = 4;
constexpr std::int64_t kDistractorSearchPhase = 1;
constexpr std::size_t kMaxDistractors = 8;
/// Share of the fully visible log likelihood ratio that makes an object a distractor.
constexpr double kDistractorShare = 0.6;
/// Frames after which a distractor must be partly visible: it was two objects whose
/// rays were crossed wrongly, or it went behind another one.
constexpr int kGraceUpdates = 3;

bool isNewDistractor(const Candidate& candidate, const TrackedObjects& objects,
                     SphereObservation& observation, double logLikelihoodRatio) {
  observation.setRadius(candidate.radius);
  const double fullyVisible =
      observation.fullyVisibleLogLikelihoodRatio(candidate.center, Eigen::Vector3d::Zero());
  const auto occupied = objects.spheresOfOthers(objects.size());
  const bool taken = std::any_of(occupied.begin(), occupied.end(), [&](const auto& sphere) {
    return (sphere.center - candidate.center).norm() < sphere.radius + candidate.radius;
  });
  return !taken && logLikelihoodRatio >= kDistractorShare * fullyVisible;
}

} // namespace

DistractorSearch::DistractorSearch(const DistractorSearch& other)
    : frameCount_(other.frameCount_), nextStream_(other.nextStream_),
      slicedTarget_(other.slicedTarget_), nextSlicedFrame_(other.nextSlicedFrame_) {}

void DistractorSearch::restart(std::size_t targetCount) {
  sliced_.reset();
  nextSlicedFrame_ = 0;
  frameCount_ = 0;
  nextStream_ = static_cast<std::uint32_t>(targetCount);
}

void DistractorSearch::removeLostDistractors(TrackedObjects& objects) {
  for (std::size_t k = objects.size(); k-- > objects.targetCount();) {
    const TrackHypothesis* own = objects[k].track.confidentHypothesis();
    const bool faint = own != nullptr && own->updateCount > kGraceUpdates &&
                       own->logLikelihoodRatio < TrackHypothesis::kPartlyVisibleShare *
                                                     own->fullyVisibleLogLikelihoodRatio;
    if (own == nullptr || faint) {
      objects.removeDistractor(k);
    }
  }
}

void DistractorSearch::search(const Context& context, ThreadTeam& team) {
  const std::int64_t frame = frameCount_++;
  const TrackedObjects& objects = context.objects;
  if (context.budget.isLimited()) {
    searchInSlices(context, team);
    return;
  }
  if (frame % kDistractorSearchPeriod != kDistractorSearchPhase || objects.targetCount() == 0 ||
      !objects.areAllTargetsVisible()) {
    return;
  }
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    if (objects.isFirstOfItsColor(k) && objects.mayHaveDistractors(k)) {
      searchFor(k, context, team);
    }
  }
}

void DistractorSearch::searchFor(std::size_t target, const Context& context, ThreadTeam& team) {
  TrackedObjects& objects = context.objects;
  if (objects.distractorCount() >= kMaxDistractors) {
    return;
  }
  const double radius = objects[target].track.target().radius;
  TrackedObject probe = objects.makeDistractorProbe(target, context.settings);
  context.images.passImagesTo(probe.observation, probe.color);
  // Otherwise the wrongly crossed rays of two known objects would make a third.
  objects.markPixelsOfOthers(probe.observation, probe);
  probe.observation.setRadius(radius);
  for (const Candidate& candidate :
       context.candidates.find(probe.observation, radius > 0.0, kMaxDistractors)) {
    if (isNewDistractor(candidate, objects, probe.observation, candidate.logLikelihoodRatio)) {
      add(std::move(probe), candidate, context, team);
      return; // one at a time
    }
  }
}

void DistractorSearch::searchInSlices(const Context& context, ThreadTeam& team) {
  const TrackedObjects& objects = context.objects;
  const std::int64_t frame = frameCount_ - 1;
  const bool full = objects.distractorCount() >= kMaxDistractors;
  if (full || objects.targetCount() == 0 || !objects.areAllTargetsVisible()) {
    sliced_.reset();
    return;
  }
  if (!sliced_) {
    bool any = false;
    for (std::size_t k = 0; k < objects.targetCount(); ++k) {
      any = any || (objects.isFirstOfItsColor(k) && objects.mayHaveDistractors(k));
    }
    if (frame < nextSlicedFrame_ || !any) {
      return;
    }
    nextSlicedFrame_ = frame + kDistractorSearchPeriod;
    do { // the next target, of those that do not share their color with an earlier one
      slicedTarget_ = (slicedTarget_ + 1) % objects.targetCount();
    } while (!objects.isFirstOfItsColor(slicedTarget_) ||
             !objects.mayHaveDistractors(slicedTarget_));
    sliced_ = objects.startSearch(objects.makeDistractorProbe(slicedTarget_, context.settings),
                                  context.images);
  }
  const auto candidates =
      advanceSearch(sliced_, context.candidates, context.budget, kMaxDistractors, false);
  if (candidates.empty()) {
    return;
  }
  // The candidates are some frames old: finds where they are now.
  TrackedObject probe = objects.makeDistractorProbe(slicedTarget_, context.settings);
  context.images.passImagesTo(probe.observation, probe.color);
  objects.markPixelsOfOthers(probe.observation, probe);
  for (Candidate candidate : candidates) {
    OutlinePrior prior;
    prior.center = candidate.center;
    prior.radius = candidate.radius;
    prior.information = Eigen::Matrix3d::Identity() / (candidate.radius * candidate.radius);
    const OutlineFit fit = probe.observation.fit(prior, Eigen::Vector3d::Zero());
    candidate.center = fit.isFound ? fit.center : candidate.center;
    probe.observation.setRadius(candidate.radius);
    const double now =
        probe.observation.logLikelihoodRatio(candidate.center, Eigen::Vector3d::Zero());
    if (isNewDistractor(candidate, objects, probe.observation, now)) {
      add(std::move(probe), candidate, context, team);
      return;
    }
  }
}

void DistractorSearch::add(TrackedObject distractor, const Candidate& candidate,
                           const Context& context, ThreadTeam& team) {
  distractor.randomStreamId = nextStream_++;
  TrackedObject& added = context.objects.addDistractor(std::move(distractor));
  // Shown again, without what the search had explained by others.
  context.images.passImagesTo(added.observation, added.color);
  added.track.initializeAt(candidate.center, candidate.radius, added.observation,
                           added.randomKey(context.key), team);
}

} // namespace dewpoint::tracking
