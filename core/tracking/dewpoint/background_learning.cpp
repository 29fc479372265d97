// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/background_learning.h"

#include <algorithm>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 2).

/// Around a target's outline (radii and pixels) the background is not learned: its shadow and
/// reflection lie there.
constexpr double kNotLearnedRadii = 1.4;
constexpr double kNotLearnedPx = 2.0;
/// Least existence of targets that are surely where they are, so that nothing else is one.
constexpr double kSurelyThere = 0.95;

} // namespace

std::vector<BackgroundModel::ExcludedCircle> excludedCircles(const TrackedObjects& objects,
                                                             std::size_t camera) {
  std::vector<BackgroundModel::ExcludedCircle> hidden;
  for (const TrackedObject& object : objects) {
    const TrackHypothesis* best = object.track.mostLikelyHypothesis();
    if (best == nullptr || (object.isBall() && !best->hasRim())) {
      continue; // a part of something larger hides nothing
    }
    if (const auto outline =
            object.observation.projector(camera).project(best->position(), best->radius)) {
      const double wider =
          object.isBall() ? 1.0 : object.shapeTracking->track().longestAxis() / best->radius;
      hidden.push_back(
          {outline->center, wider * kNotLearnedRadii * outline->radius + kNotLearnedPx});
    }
  }
  return hidden;
}

bool noTargetIsElsewhere(const TrackedObjects& objects, std::size_t cameraCount,
                         const std::vector<SphereEstimate>& estimates) {
  const int fewest = std::min<int>(2, static_cast<int>(cameraCount));
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    const TrackHypothesis* const best = objects[k].track.confidentHypothesis();
    const SphereEstimate& estimate = estimates[k];
    if (best == nullptr || !best->hasRim() || !best->wasOutlineFound || !objects[k].isBall() ||
        best->logLikelihoodRatio <
            TrackHypothesis::kMostlyVisibleShare * best->fullyVisibleLogLikelihoodRatio ||
        !estimate.isValid || estimate.existenceProbability < kSurelyThere ||
        estimate.seeingCameraCount < fewest) {
      return false;
    }
  }
  return true;
}

void forgetFamiliarPixelsAt(const TrackedObject& object, const Eigen::Vector3d& position,
                            FrameImages& images) {
  const TrackHypothesis* const best = object.track.mostLikelyHypothesis();
  const double radius = best != nullptr ? best->radius : object.track.target().radius;
  if (radius <= 0.0) { // nobody knows how much of the images it takes
    images.forgetFamiliarPixels();
    return;
  }
  for (std::size_t camera = 0; camera < images.cameraCount(); ++camera) {
    if (const auto outline = object.observation.projector(camera).project(position, radius)) {
      images.forgetFamiliarPixels(
          camera, {outline->center, kNotLearnedRadii * outline->radius + kNotLearnedPx});
    }
  }
}

void forgetFamiliarPixelsOfLostTargets(TrackedObjects& objects, FrameImages& images,
                                       double interval, double patience) {
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    TrackedObject& object = objects[k];
    const double before = object.secondsSinceTracked;
    object.secondsSinceTracked =
        object.track.confidentHypothesis() != nullptr ? 0.0 : before + interval;
    if (before < patience && object.secondsSinceTracked >= patience) {
      images.forgetFamiliarPixels();
    }
  }
}

} // namespace dewpoint::tracking
