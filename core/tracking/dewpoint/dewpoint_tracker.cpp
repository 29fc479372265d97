// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_tracker.h"

#include "core/base/angle.h"
#include "core/tracking/dewpoint/background_learning.h"
#include "core/tracking/dewpoint/clock_sightings.h"
#include "core/tracking/dewpoint/color_adaptation.h"
#include "core/tracking/dewpoint/dewpoint_diagnostics.h"
#include "core/tracking/dewpoint/object_update.h"
#include "core/tracking/frame_gap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, sections 1 and 2).

/// Frames in which the reach of a color is updated in each after the start, or after its track
/// was lost, and frames from one update to the next after these. Judgments
/// (docs/method-dewpoint.md, section 8): the exposure settles within the first, daylight changes
/// slowly.
constexpr int kReachFrames = 10;
constexpr int kReachPeriod = 10;

} // namespace

DewpointTracker::DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                                 const std::vector<Target>& targets)
    : parameters_(parameters), objects_(targets, rig), images_(rig.size()), clocks_(rig),
      search_(rig), estimates_(targets.size()) {
  restart(0);
}

BernoulliTrackSettings DewpointTracker::trackSettings() const {
  BernoulliTrackSettings settings;
  settings.maxParticles = static_cast<Eigen::Index>(parameters_.at("particles"));
  if (const auto affordable = budget_.affordableParticleCount()) {
    settings.maxParticles = std::min(static_cast<Eigen::Index>(*affordable), settings.maxParticles);
  }
  settings.minParticles = std::min(static_cast<Eigen::Index>(parameters_.at("fewest_particles")),
                                   settings.maxParticles);
  settings.kldError = parameters_.at("kld_error");
  settings.accelerationSigma = parameters_.at("acceleration_sigma");
  settings.survivalSeconds = parameters_.at("survival_time");
  settings.searchCubeEdge = parameters_.at("search_size");
  settings.systematicErrors.directionSigma = parameters_.at("calibration_error") * kDegree;
  settings.systematicErrors.timeSigma = 1e-3 * parameters_.at("time_error");
  return settings;
}

void DewpointTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  for (TrackedObject& object : objects_) {
    object.track.configure(trackSettings());
    if (parameters_.at("color_adaptation") <= 0.0) {
      object.color.undoAdaptation();
    }
  }
  if (!lastTime_) {
    restart(key_.seed);
  }
}

void DewpointTracker::setTargets(const std::vector<Target>& targets) {
  objects_.removeDistractors();
  distractors_.cancel();
  for (std::size_t k = 0; k < std::min(targets.size(), objects_.targetCount()); ++k) {
    TrackedObject& object = objects_[k];
    if (!(targets[k].colors() == object.track.target().colors())) {
      images_.resetReferenceLight();  // the color was picked in the light of now
      images_.forgetFamiliarPixels(); // what is empty was found by the colors of before
      object.color = AdaptiveColor(targets[k].colors(), images_.cameraCount());
    }
    object.track.setTarget(targets[k]);
    object.shapeTracking->setTarget(targets[k]);
    object.search.reset();
  }
}

void DewpointTracker::setCameras(const CameraRig& rig) {
  if (rig.size() != images_.cameraCount()) {
    return; // another rig is another run
  }
  search_ = CandidateSearch(rig);
  clocks_.setCameras(rig);
  images_.setDelays(clocks_.delays());
  distractors_.cancel();
  // What depends on the images only, such as the backgrounds, stays; the tracks of distractors move
  // along with those of the targets.
  objects_.setCameras(rig);
  for (TrackedObject& object : objects_) {
    images_.passImagesTo(object.observation, object.color);
  }
}

void DewpointTracker::setVolumeOfInterest(const std::optional<WorldBox>& volume) {
  for (std::size_t k = 0; k < objects_.targetCount(); ++k) {
    objects_[k].track.setBounds(volume);
    objects_[k].shapeTracking->track().setBounds(volume);
    objects_[k].search.reset();
  }
  if (!lastTime_) {
    restart(key_.seed);
  }
}

void DewpointTracker::correctPosition(std::size_t target, const Gaussian3& position,
                                      ThreadTeam& team) {
  TrackedObject& object = objects_[target];
  object.search.reset();
  forgetFamiliarPixelsAt(object, position.mean, images_);
  // Without what other objects explain: what the user points at is the target.
  images_.passImagesTo(object.observation, object.color);
  if (object.isBall()) {
    object.track.correct(position, object.observation, object.randomKey(key_), team);
  } else {
    images_.passImagesTo(object.shapeTracking->observation(), object.color);
    object.shapeTracking->correct(position, object.track.target().radius, object.randomKey(key_),
                                  team);
    object.track.setOnlyHypothesis(object.shapeTracking->track().hypothesis());
  }
  updateEstimate(target);
  if (!estimates_[target].measurement) {
    estimates_[target].measurement = position; // what the user measured in this frame
  }
  for (const std::size_t other : objects_.removeOthersAtPositionOf(target)) {
    updateEstimate(other);
  }
}

void DewpointTracker::setBackgroundImages(const std::vector<cv::Mat>& images) {
  images_.setBackgroundImages(images);
}

void DewpointTracker::restart(std::uint64_t seed) {
  key_ = {seed, 0, 0};
  lastTime_.reset();
  budget_ = TimeBudget();
  images_.resetBackgrounds();
  clocks_.restart();
  images_.setDelays(clocks_.delays());
  objects_.removeDistractors();
  distractors_.restart(objects_.targetCount());
  for (TrackedObject& object : objects_) {
    object.search.reset();
    object.color.restoreLearnedRanges();
    object.unseenFrameCount = 0;
    object.secondsSinceTracked = 0.0;
    object.track.configure(trackSettings());
    object.track.restart(startVolumeOf(parameters_), object.randomKey(key_).seed);
    object.shapeTracking->track().configure(trackSettings());
    object.shapeTracking->restart(startVolumeOf(parameters_));
  }
  estimates_.assign(objects_.targetCount(), SphereEstimate{});
}

int DewpointTracker::iterationsPerFrame() const {
  return static_cast<int>(parameters_.at("iterations_per_frame"));
}

double DewpointTracker::secondsSinceLastFrame() const {
  if (!lastTime_ || !images_.frames()) {
    return 0.0;
  }
  const double interval = seconds(images_.frames()->time - *lastTime_);
  return interval < 0.0 ? kDefaultGap : std::min(interval, kLongestGap);
}

void DewpointTracker::beginFrame(FrameSetPtr frames) {
  key_.iteration = 0;
  key_.frame = frames ? static_cast<std::uint32_t>(frames->index) : 0;
  images_.setFrames(std::move(frames));
}

void DewpointTracker::iterate(ThreadTeam& team) {
  const bool isFirst = key_.iteration == 0; // of the iterations on this frame
  budget_.setLimit(parameters_.at("time_budget"));
  budget_.beginIteration();
  for (TrackedObject& object : objects_) {
    object.track.configure(trackSettings());
    if (object.shapeTracking) {
      object.shapeTracking->track().configure(trackSettings());
    }
  }
  if (isFirst) {
    predictTracks();
    images_.adaptToLight();
    extendColorsToLight();
  }
  ObjectUpdate({objects_, images_, clocks_, search_, budget_, key_}, team).updateAllObjects();
  budget_.adaptParticleCount(parameters_.at("particles"));
  if (isFirst) {
    searchDistractors(team);
  }
  updateEstimates();
  if (isFirst) {
    learnClocks();
    adaptTargetColors();
    learnBackgrounds();
    lastTime_ = images_.frames() ? images_.frames()->time : TimeStamp{};
  }
  ++key_.iteration;
}

void DewpointTracker::predictTracks() {
  for (TrackedObject& object : objects_) {
    if (object.isBall()) {
      object.track.predict(secondsSinceLastFrame(), object.randomKey(key_));
    }
    if (object.shapeTracking) {
      object.shapeTracking->predict(secondsSinceLastFrame(), object.randomKey(key_));
    }
  }
}

void DewpointTracker::extendColorsToLight() {
  for (std::size_t k = 0; k < objects_.targetCount(); ++k) {
    TrackedObject& object = objects_[k];
    if (object.track.confidentHypothesis() != nullptr) {
      object.unseenFrameCount = 0;
      continue;
    }
    if (object.unseenFrameCount < kReachFrames || object.unseenFrameCount % kReachPeriod == 0) {
      for (std::size_t camera = 0; camera < images_.cameraCount(); ++camera) {
        if (const FramePtr frame = images_.frame(camera)) {
          object.color.extendToLight(camera, frame->image);
        }
      }
    }
    ++object.unseenFrameCount;
  }
}

void DewpointTracker::searchDistractors(ThreadTeam& team) {
  DistractorSearch::removeLostDistractors(objects_);
  objects_.resolveIdentities();
  distractors_.search({objects_, images_, search_, budget_, trackSettings(), key_}, team);
}

void DewpointTracker::updateEstimates() {
  for (std::size_t k = 0; k < objects_.targetCount(); ++k) {
    updateEstimate(k);
  }
}

void DewpointTracker::updateEstimate(std::size_t target) {
  TrackedObject& object = objects_[target];
  estimates_[target] =
      !object.isBall() && object.shapeTracking->track().hypothesis() != nullptr
          ? object.shapeTracking->track().estimate(object.shapeTracking->observation())
          : object.track.estimate(object.observation);
  estimates_[target].colors = object.color.rangesInUse();
}

void DewpointTracker::learnClocks() {
  clocks_.setPrior(
      {1e-3 * parameters_.at("delay_spread"), trackSettings().systematicErrors.directionSigma});
  clocks_.learn(clockSightings(objects_), secondsSinceLastFrame());
  images_.setDelays(clocks_.delays());
}

void DewpointTracker::adaptTargetColors() {
  const double timeConstant = parameters_.at("color_adaptation");
  if (timeConstant > 0.0) {
    adaptColors(objects_, images_, estimates_,
                -std::expm1(-secondsSinceLastFrame() / timeConstant));
  }
}

void DewpointTracker::learnBackgrounds() {
  forgetFamiliarPixelsOfLostTargets(objects_, images_, secondsSinceLastFrame(),
                                    parameters_.at("survival_time"));
  const bool noTargetElsewhere = noTargetIsElsewhere(objects_, images_.cameraCount(), estimates_);
  for (std::size_t camera = 0; camera < images_.cameraCount(); ++camera) {
    if (images_.frame(camera)) {
      budget_.runIfAffordable(TimeBudget::Stage::Learning, [&] {
        images_.learnBackground(camera, excludedCircles(objects_, camera), noTargetElsewhere);
      });
    }
  }
}

void DewpointTracker::copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                    Eigen::ArrayXd& weights) const {
  objects_[target].track.copyParticles(limit, positions, weights);
}

std::unique_ptr<Tracker> DewpointTracker::clone() const {
  return std::unique_ptr<Tracker>(new DewpointTracker(*this));
}

std::size_t DewpointTracker::memoryBytes() const {
  std::size_t bytes = images_.memoryBytes();
  for (const TrackedObject& object : objects_) {
    bytes += object.track.memoryBytes();
    bytes += object.shapeTracking ? object.shapeTracking->track().memoryBytes() : 0;
  }
  return bytes;
}

std::vector<CameraReport> DewpointTracker::cameraReports(std::size_t target) const {
  return cameraReportsOf(objects_, images_, estimates_.at(target), target);
}

std::vector<CandidatePosition> DewpointTracker::positionCandidates(std::size_t target) const {
  return candidatePositions(objects_, target);
}

std::vector<LikelihoodMap> DewpointTracker::likelihoodMaps(std::size_t target, int reach) const {
  return likelihoodMapsOf(objects_, images_, estimates_.at(target), target, reach);
}

} // namespace dewpoint::tracking
