// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_tracker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dewpoint::tracking {
namespace {

/// A gap longer than this is a new scene as far as motion is concerned.
constexpr double kLongestGap = 1.0; // seconds
constexpr double kDefaultGap = 1.0 / 30.0;
/// Around a target's outline nothing is learned: its shadow and reflection lie there.
constexpr double kNotLearnedRadii = 1.4;
constexpr double kOutlineMargin = 1.05;

bool overlap(const TrackHypothesis& a, const TrackHypothesis& b) {
  return (a.position() - b.position()).norm() <= kTouching * (a.radius + b.radius);
}

} // namespace

DewpointTracker::DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                                 const std::vector<Target>& targets)
    : parameters_(parameters), rig_(rig), targetCount_(targets.size()), backgrounds_(rig.size()),
      search_(rig), estimates_(targets.size()) {
  for (const Target& target : targets) {
    tracked_.push_back({BernoulliTrack(target), SphereObservation(rig),
                        AdaptiveColor(target.color, rig.size()), nullptr});
  }
  restart(0);
}

BernoulliTrackSettings DewpointTracker::settings() const {
  BernoulliTrackSettings settings;
  settings.maxParticles = static_cast<Eigen::Index>(parameters_.at("particles"));
  if (const auto affordable = budget_.particles()) {
    settings.maxParticles = std::min(static_cast<Eigen::Index>(*affordable), settings.maxParticles);
  }
  settings.minParticles = std::min(static_cast<Eigen::Index>(parameters_.at("fewest_particles")),
                                   settings.maxParticles);
  settings.kldError = parameters_.at("kld_error");
  settings.accelerationSigma = parameters_.at("acceleration_sigma");
  settings.survivalTime = parameters_.at("survival_time");
  settings.searchSize = parameters_.at("search_size");
  return settings;
}

void DewpointTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  for (Tracked& tracked : tracked_) {
    tracked.belief.configure(settings());
    if (parameters_.at("color_adaptation") <= 0.0) {
      tracked.color.forget();
    }
  }
  if (!lastTime_) {
    restart(key_.seed);
  }
}

void DewpointTracker::setTargets(const std::vector<Target>& targets) {
  tracked_.erase(tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_), tracked_.end());
  streams_.resize(targetCount_);
  lookAround_.reset();
  for (std::size_t k = 0; k < std::min(targets.size(), targetCount_); ++k) {
    if (!(targets[k].color == tracked_[k].belief.target().color)) {
      // The color was picked in the light of now.
      for (BackgroundModel& background : backgrounds_) {
        background.takeLightAsUsual();
      }
      tracked_[k].color = AdaptiveColor(targets[k].color, rig_.size());
    }
    tracked_[k].belief.setTarget(targets[k]);
    tracked_[k].search.reset();
  }
}

void DewpointTracker::setCameras(const CameraRig& rig) {
  if (rig.size() != rig_.size()) {
    return; // another rig is another run
  }
  rig_ = rig;
  search_ = CandidateSearch(rig);
  lookAround_.reset();
  // What hangs on the images, as backgrounds do, stays; the beliefs of look-alikes move along with
  // those of the targets.
  for (Tracked& tracked : tracked_) {
    tracked.observation = SphereObservation(rig);
    tracked.search.reset();
    showImages(tracked.observation, tracked.color);
  }
}

void DewpointTracker::setEmptyRooms(const std::vector<cv::Mat>& rooms) {
  for (std::size_t camera = 0; camera < std::min(rooms.size(), backgrounds_.size()); ++camera) {
    backgrounds_[camera].setEmptyRoom(rooms[camera]);
  }
}

void DewpointTracker::restart(std::uint64_t seed) {
  key_ = {seed, 0, 0};
  lastTime_.reset();
  budget_ = TimeBudget();
  lookAround_.reset();
  nextLookAround_ = 0;
  for (BackgroundModel& background : backgrounds_) {
    background.reset();
  }
  tracked_.erase(tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_), tracked_.end());
  frameCount_ = 0;
  nextLookAlike_ = static_cast<std::uint32_t>(targetCount_);
  streams_.resize(targetCount_);
  std::iota(streams_.begin(), streams_.end(), 0U);
  for (std::size_t k = 0; k < targetCount_; ++k) {
    tracked_[k].search.reset();
    tracked_[k].color.forget();
    tracked_[k].belief.configure(settings());
    tracked_[k].belief.restart(startVolume(parameters_), keyOf(k).seed);
  }
  estimates_.assign(targetCount_, SphereEstimate{});
}

int DewpointTracker::iterationsPerFrame() const {
  return static_cast<int>(parameters_.at("iterations_per_frame"));
}

RandomKey DewpointTracker::keyOf(std::size_t index) const {
  return {derivedSeed(key_.seed, streams_[index]), key_.frame, key_.iteration};
}

double DewpointTracker::secondsSinceLastFrame() const {
  if (!lastTime_ || !frames_) {
    return 0.0;
  }
  const double interval = seconds(frames_->time - *lastTime_);
  // Backwards: the user went to an earlier frame.
  return interval < 0.0 ? kDefaultGap : std::min(interval, kLongestGap);
}

void DewpointTracker::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  key_.iteration = 0;
  key_.frame = frames_ ? static_cast<std::uint32_t>(frames_->index) : 0;
}

FramePtr DewpointTracker::frameOf(std::size_t camera) const {
  return frames_ && camera < frames_->frames.size() ? frames_->frames[camera] : nullptr;
}

double DewpointTracker::timeOffsetOf(std::size_t camera) const {
  const FramePtr frame = frameOf(camera);
  return frame ? seconds(frame->captureTime - frames_->time) : 0.0;
}

void DewpointTracker::showImages(SphereObservation& observation, const AdaptiveColor& color) {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    const FramePtr frame = frameOf(camera);
    observation.setImage(camera, frame ? frame->image : cv::Mat(), timeOffsetOf(camera),
                         backgrounds_[camera], color.inUse(camera), color.learned());
  }
}

std::vector<std::size_t> DewpointTracker::surestFirst() const {
  std::vector<std::size_t> order(tracked_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto probability = [&](std::size_t k) {
    const TrackHypothesis* best = tracked_[k].belief.best();
    return best != nullptr ? best->probability : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probability(a) > probability(b); });
  return order;
}

std::vector<OccupiedSphere> DewpointTracker::occupiedByOthers(std::size_t index) const {
  std::vector<OccupiedSphere> occupied;
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    const TrackHypothesis* other = k != index ? tracked_[k].belief.confident() : nullptr;
    if (other != nullptr) {
      occupied.push_back({other->position(), other->radius});
    }
  }
  return occupied;
}

void DewpointTracker::explainOthers(SphereObservation& observation, const Tracked& own) {
  const TrackHypothesis* mine = own.belief.confident();
  for (const Tracked& tracked : tracked_) {
    const TrackHypothesis* other = &tracked != &own ? tracked.belief.confident() : nullptr;
    // Only what is plainly there itself explains anything.
    const bool plain = other != nullptr && other->measured &&
                       other->logLikelihoodRatio > TrackHypothesis::kMostlyVisibleShare *
                                                       other->fullyVisibleLogLikelihoodRatio &&
                       tracked.belief.target().color == own.belief.target().color;
    for (std::size_t camera = 0; plain && camera < backgrounds_.size(); ++camera) {
      LabelImage& labels = observation.labels(camera);
      const SphereProjector& projector = observation.projector(camera);
      const auto outline = projector.project(other->position(), other->radius);
      if (labels.empty() || !outline) {
        continue;
      }
      // What lies in front of the other stays this target's own.
      LabelImage::Circle kept;
      const auto ownOutline =
          mine != nullptr ? projector.project(mine->position(), mine->radius) : std::nullopt;
      if (ownOutline && projector.depth(mine->position()) < projector.depth(other->position())) {
        kept = {ownOutline->center, kOutlineMargin * ownOutline->radius};
      }
      labels.explain({outline->center, kOutlineMargin * outline->radius + 1.0}, kept);
    }
  }
}

void DewpointTracker::iterate(ThreadTeam& team) {
  budget_.set(parameters_.at("time_budget"));
  budget_.begin();
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    tracked_[k].belief.configure(settings());
    if (key_.iteration == 0) {
      tracked_[k].belief.predict(secondsSinceLastFrame(), keyOf(k));
    }
  }
  if (key_.iteration == 0) {
    followLight();
  }
  for (std::size_t k = targetCount_; k < tracked_.size(); ++k) {
    yieldToTargets(tracked_[k]);
  }
  for (const std::size_t k : surestFirst()) {
    updateBelief(k, team);
  }
  resolveConflicts();
  budget_.endOfUpdates(parameters_.at("particles"));
  if (key_.iteration == 0) {
    watchLookAlikes(team);
    ++frameCount_;
  }
  for (std::size_t k = 0; k < targetCount_; ++k) {
    estimates_[k] = tracked_[k].belief.estimate(tracked_[k].observation);
    estimates_[k].colors = tracked_[k].color.rangesInUse();
  }
  if (key_.iteration == 0) {
    followColors();
    learnBackgrounds();
    lastTime_ = frames_ ? frames_->time : TimeStamp{};
  }
  ++key_.iteration;
}

void DewpointTracker::updateBelief(std::size_t index, ThreadTeam& team) {
  Tracked& tracked = tracked_[index];
  showImages(tracked.observation, tracked.color);
  explainOthers(tracked.observation, tracked);
  const auto findNow = [this](SphereObservation& observation, bool radiusKnown, std::size_t limit) {
    return search_.find(observation, radiusKnown, limit);
  };
  bool searched = false;
  const auto findInSlices = [&](SphereObservation&, bool, std::size_t limit) {
    searched = true;
    if (!tracked.search) {
      tracked.search = beginSearch(tracked);
    }
    return goOn(tracked.search, limit, true);
  };
  const CandidateSource search =
      budget_.limited() ? CandidateSource(findInSlices) : CandidateSource(findNow);
  tracked.belief.update(tracked.observation, search, occupiedByOthers(index), keyOf(index), team);
  if (!searched) {
    tracked.search.reset(); // what a search found in old images is of no use later
  }
  if (index >= targetCount_) {
    yieldToTargets(tracked);
  }
}

void DewpointTracker::yieldToTargets(Tracked& lookAlike) {
  const TrackHypothesis* place = lookAlike.belief.confident();
  for (std::size_t k = 0; k < targetCount_ && place != nullptr; ++k) {
    const TrackHypothesis* target = tracked_[k].belief.confident();
    // Plainly seen a moment ago: it is still there. (One that is hidden may be believed in the
    // wrong place.)
    if (target != nullptr && target->isSaturated() && overlap(*place, *target)) {
      lookAlike.belief.suppressBest();
      place = nullptr;
    }
  }
}

void DewpointTracker::resolveConflicts() {
  for (std::size_t a = 0; a < tracked_.size(); ++a) {
    for (std::size_t b = a + 1; b < tracked_.size(); ++b) {
      const TrackHypothesis* first = tracked_[a].belief.confident();
      const TrackHypothesis* second = tracked_[b].belief.confident();
      if (first == nullptr || second == nullptr || !overlap(*first, *second)) {
        continue;
      }
      (first->logLikelihoodRatio >= second->logLikelihoodRatio ? tracked_[b] : tracked_[a])
          .belief.suppressBest();
    }
  }
}

void DewpointTracker::followLight() {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    if (const FramePtr frame = frameOf(camera)) {
      backgrounds_[camera].followLight(frame->image);
    }
  }
}

void DewpointTracker::learnBackgrounds() {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    const FramePtr frame = frameOf(camera);
    if (!frame) {
      continue;
    }
    std::vector<BackgroundModel::Hidden> hidden;
    for (const Tracked& tracked : tracked_) {
      const TrackHypothesis* best = tracked.belief.best();
      if (best == nullptr) {
        continue;
      }
      const auto outline =
          tracked.observation.projector(camera).project(best->position(), best->radius);
      if (outline) {
        hidden.push_back({outline->center, kNotLearnedRadii * outline->radius + 2.0});
      }
    }
    budget_.spend(TimeBudget::Part::Learning,
                  [&] { backgrounds_[camera].learn(frame->image, hidden); });
  }
}

void DewpointTracker::particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                Eigen::ArrayXd& weights) const {
  tracked_.at(target).belief.particles(limit, positions, weights);
}

} // namespace dewpoint::tracking
