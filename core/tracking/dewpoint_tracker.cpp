// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint_tracker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace dewpoint {
namespace {

/// A gap longer than this is a new scene as far as motion is concerned.
constexpr double kLongestGap = 1.0; // seconds
constexpr double kDefaultGap = 1.0 / 30.0;
/// Two spheres of radii a and b cannot be closer than a + b; estimates may err a little.
constexpr double kTouching = 0.7;
/// Around a target's outline nothing is learned: its shadow and reflection lie there.
constexpr double kNotLearnedRadii = 1.4;
constexpr double kOutlineMargin = 1.05;
/// Look-alikes are looked for every so many frames, soon after the start for the first time.
constexpr std::int64_t kLookAroundEvery = 4;
constexpr std::int64_t kLookAroundPhase = 1;
constexpr std::size_t kMostLookAlikes = 8;
/// Evidence, as a share of the best, that makes a thing a look-alike.
constexpr double kLookAlikeShare = 0.6;
constexpr double kSureOfTarget = 0.9;
constexpr double kWellSeen = 0.55; ///< share of the best evidence
/// A look-alike that has less than this share of the best evidence, after some looks, is dropped:
/// it was two things seen crosswise, or went behind another.
constexpr double kFaint = 0.25;
constexpr int kLooksOfGrace = 3;

bool overlap(const Hypothesis& a, const Hypothesis& b) {
  return (a.place() - b.place()).norm() <= kTouching * (a.radius + b.radius);
}

} // namespace

DewpointTracker::DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                                 const std::vector<Target>& targets)
    : parameters_(parameters), rig_(rig), targetCount_(targets.size()), backgrounds_(rig.size()),
      search_(rig), estimates_(targets.size()) {
  for (const Target& target : targets) {
    tracked_.push_back(
        {TargetBelief(target), SphereObservation(rig), ColorClassifier(target.color)});
  }
  restart(0);
}

BeliefSettings DewpointTracker::settings() const {
  BeliefSettings settings;
  settings.mostParticles = static_cast<Eigen::Index>(parameters_.at("particles"));
  if (affordableParticles_ > 0.0) {
    settings.mostParticles = std::clamp<Eigen::Index>(
        static_cast<Eigen::Index>(affordableParticles_), 10, settings.mostParticles);
  }
  settings.fewestParticles = std::min(static_cast<Eigen::Index>(parameters_.at("fewest_particles")),
                                      settings.mostParticles);
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
  }
  if (!lastTime_) {
    restart(key_.seed);
  }
}

void DewpointTracker::setTargets(const std::vector<Target>& targets) {
  tracked_.erase(tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_), tracked_.end());
  streams_.resize(targetCount_);
  for (std::size_t k = 0; k < std::min(targets.size(), targetCount_); ++k) {
    if (!(targets[k].color == tracked_[k].belief.target().color)) {
      // The color was picked in the light of now.
      for (BackgroundModel& background : backgrounds_) {
        background.takeLightAsUsual();
      }
    }
    tracked_[k].belief.setTarget(targets[k]);
    tracked_[k].classifier = ColorClassifier(targets[k].color);
  }
}

void DewpointTracker::restart(std::uint64_t seed) {
  key_ = {seed, 0, 0};
  lastTime_.reset();
  affordableParticles_ = 0.0;
  for (BackgroundModel& background : backgrounds_) {
    background.reset();
  }
  tracked_.erase(tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_), tracked_.end());
  frameCount_ = 0;
  nextLookAlike_ = static_cast<std::uint32_t>(targetCount_);
  streams_.resize(targetCount_);
  std::iota(streams_.begin(), streams_.end(), 0U);
  for (std::size_t k = 0; k < targetCount_; ++k) {
    tracked_[k].belief.configure(settings());
    tracked_[k].belief.restart(startVolume(parameters_), keyOf(k).seed);
  }
  estimates_.assign(targetCount_, TargetEstimate{});
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

void DewpointTracker::showImages(Tracked& tracked) {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    const FramePtr frame = frameOf(camera);
    const double offset = frame ? seconds(frame->captureTime - frames_->time) : 0.0;
    tracked.observation.setImage(camera, frame ? frame->image : cv::Mat(), offset,
                                 backgrounds_[camera], tracked.classifier);
  }
}

std::vector<std::size_t> DewpointTracker::surestFirst() const {
  std::vector<std::size_t> order(tracked_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto probability = [&](std::size_t k) {
    const Hypothesis* best = tracked_[k].belief.best();
    return best != nullptr ? best->probability : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probability(a) > probability(b); });
  return order;
}

std::vector<OccupiedSphere> DewpointTracker::occupiedByOthers(std::size_t index) const {
  std::vector<OccupiedSphere> occupied;
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    const Hypothesis* other = k != index ? tracked_[k].belief.confident() : nullptr;
    if (other != nullptr) {
      occupied.push_back({other->place(), other->radius});
    }
  }
  return occupied;
}

void DewpointTracker::explainOthers(Tracked& own) {
  const Hypothesis* mine = own.belief.confident();
  for (const Tracked& tracked : tracked_) {
    const Hypothesis* other = &tracked != &own ? tracked.belief.confident() : nullptr;
    // Only what is plainly there itself explains anything.
    const bool plain = other != nullptr && other->measured &&
                       other->logRatio > kWellSeen * other->bestLogRatio &&
                       tracked.belief.target().color == own.belief.target().color;
    for (std::size_t camera = 0; plain && camera < backgrounds_.size(); ++camera) {
      LabelImage& labels = own.observation.labels(camera);
      const SphereProjector& projector = own.observation.projector(camera);
      const auto outline = projector.project(other->place(), other->radius);
      if (labels.empty() || !outline) {
        continue;
      }
      // What lies in front of the other stays this target's own.
      LabelImage::Circle kept;
      const auto ownOutline =
          mine != nullptr ? projector.project(mine->place(), mine->radius) : std::nullopt;
      if (ownOutline && projector.depth(mine->place()) < projector.depth(other->place())) {
        kept = {ownOutline->center, kOutlineMargin * ownOutline->radius};
      }
      labels.explain({outline->center, kOutlineMargin * outline->radius + 1.0}, kept);
    }
  }
}

void DewpointTracker::iterate(ThreadTeam& team) {
  const auto begin = std::chrono::steady_clock::now();
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
    showImages(tracked_[k]);
    explainOthers(tracked_[k]);
    tracked_[k].belief.update(tracked_[k].observation, search_, occupiedByOthers(k), keyOf(k),
                              team);
    if (k >= targetCount_) {
      yieldToTargets(tracked_[k]);
    }
  }
  resolveConflicts();
  if (key_.iteration == 0) {
    watchLookAlikes(team);
    ++frameCount_;
  }
  for (std::size_t k = 0; k < targetCount_; ++k) {
    estimates_[k] = tracked_[k].belief.estimate(tracked_[k].observation);
  }
  if (key_.iteration == 0) {
    learnBackgrounds();
    lastTime_ = frames_ ? frames_->time : TimeStamp{};
  }
  ++key_.iteration;
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  keepToBudget(took.count());
}

void DewpointTracker::yieldToTargets(Tracked& lookAlike) {
  const Hypothesis* place = lookAlike.belief.confident();
  for (std::size_t k = 0; k < targetCount_ && place != nullptr; ++k) {
    const Hypothesis* target = tracked_[k].belief.confident();
    // Plainly seen a moment ago: it is still there. (One that is hidden may be believed in the
    // wrong place.)
    if (target != nullptr && target->wellSeen() && overlap(*place, *target)) {
      lookAlike.belief.yield();
      place = nullptr;
    }
  }
}

void DewpointTracker::resolveConflicts() {
  for (std::size_t a = 0; a < tracked_.size(); ++a) {
    for (std::size_t b = a + 1; b < tracked_.size(); ++b) {
      const Hypothesis* first = tracked_[a].belief.confident();
      const Hypothesis* second = tracked_[b].belief.confident();
      if (first == nullptr || second == nullptr || !overlap(*first, *second)) {
        continue;
      }
      (first->logRatio >= second->logRatio ? tracked_[b] : tracked_[a]).belief.yield();
    }
  }
}

bool DewpointTracker::allTargetsSure() const {
  return std::all_of(tracked_.begin(), tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_),
                     [](const Tracked& tracked) {
                       const Hypothesis* best = tracked.belief.best();
                       return best != nullptr && best->probability > kSureOfTarget &&
                              best->logRatio > kWellSeen * best->bestLogRatio;
                     });
}

void DewpointTracker::forgetLostLookAlikes() {
  for (std::size_t k = tracked_.size(); k-- > targetCount_;) {
    const Hypothesis* seen = tracked_[k].belief.confident();
    const bool faint = seen != nullptr && seen->looks > kLooksOfGrace &&
                       seen->logRatio < kFaint * seen->bestLogRatio;
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
    tracked_[k].belief.forgo(occupiedByOthers(k));
    tracked_[k].belief.decide(hasTwins(k));
  }
  if (frameCount_ % kLookAroundEvery != kLookAroundPhase || targetCount_ == 0 ||
      !allTargetsSure()) {
    return;
  }
  for (std::size_t k = 0; k < targetCount_; ++k) {
    const Target target = tracked_[k].belief.target(); // a copy: things are added
    const bool again = std::any_of(
        tracked_.begin(), tracked_.begin() + static_cast<std::ptrdiff_t>(k),
        [&](const Tracked& other) { return other.belief.target().color == target.color; });
    if (!again) {
      findLookAlikes(target, team);
    }
  }
}

void DewpointTracker::findLookAlikes(const Target& looks, ThreadTeam& team) {
  if (tracked_.size() >= targetCount_ + kMostLookAlikes) {
    return;
  }
  Tracked probe{TargetBelief(looks), SphereObservation(rig_), ColorClassifier(looks.color)};
  probe.belief.configure(settings());
  probe.belief.setSearching(false);
  showImages(probe);
  explainOthers(probe); // else two things seen crosswise would make a third
  probe.observation.setRadius(looks.radius);
  const auto occupied = occupiedByOthers(tracked_.size());
  for (const Candidate& candidate :
       search_.find(probe.observation, looks.radius > 0.0, kMostLookAlikes)) {
    probe.observation.setRadius(candidate.radius);
    const double best = probe.observation.bestLogRatio(candidate.center, Eigen::Vector3d::Zero());
    const bool taken = std::any_of(occupied.begin(), occupied.end(), [&](const auto& sphere) {
      return (sphere.center - candidate.center).norm() < sphere.radius + candidate.radius;
    });
    if (taken || candidate.logRatio < kLookAlikeShare * best) {
      continue;
    }
    streams_.push_back(nextLookAlike_++);
    tracked_.push_back(std::move(probe));
    Tracked& added = tracked_.back();
    showImages(added); // its labels refer to the classifier, which has moved
    added.belief.adopt(candidate.center, candidate.radius, added.observation,
                       keyOf(tracked_.size() - 1), team);
    return; // one at a time
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
      const Hypothesis* best = tracked.belief.best();
      if (best == nullptr) {
        continue;
      }
      const auto outline =
          tracked.observation.projector(camera).project(best->place(), best->radius);
      if (outline) {
        hidden.push_back({outline->center, kNotLearnedRadii * outline->radius + 2.0});
      }
    }
    backgrounds_[camera].learn(frame->image, hidden);
  }
}

void DewpointTracker::keepToBudget(double milliseconds) {
  const double budget = parameters_.at("time_budget");
  if (budget <= 0.0 || milliseconds <= 0.0) {
    affordableParticles_ = 0.0;
    return;
  }
  const double most = parameters_.at("particles");
  const double now = affordableParticles_ > 0.0 ? affordableParticles_ : most;
  // Down at once, up slowly: a budget is to be kept, not met on average.
  const double factor = std::clamp(0.8 * budget / milliseconds, 0.25, 1.1);
  affordableParticles_ = std::clamp(now * factor, 10.0, most);
}

void DewpointTracker::particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                Eigen::ArrayXd& weights) const {
  tracked_.at(target).belief.particles(limit, positions, weights);
}

} // namespace dewpoint
