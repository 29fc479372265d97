// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/bernoulli_track.h"

#include "core/filter/adaptive_size.h"
#include "core/filter/constant_velocity.h"
#include "core/filter/evenly_picked.h"
#include "core/tracking/dewpoint/track/birth_fit.h"
#include "core/tracking/dewpoint/track/track_constants.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, sections 5, 6 and 10; those without a derivation are judgments.

constexpr std::size_t kMaxCandidates = 10; ///< per search
/// Radii, standard deviation of a given position along each axis. Origin not recorded.
constexpr double kInitialSigmaRadii = 0.1;
/// Largest size misfit (squared standard deviations) that counts against an initial hypothesis.
constexpr double kMaxSizeMisfit = 20.0;
/// Probability of an identical object from which on a target is ambiguous: as of rivals that are
/// still there (hypothesis_masses.cpp).
constexpr double kAmbiguousIdentity = 0.1;
/// Radii, edge of the cubes in which KLD-sampling counts the particles.
constexpr double kBinRadii = 0.5;

} // namespace

BernoulliTrack::BernoulliTrack(const Target& target)
    : target_(target), radiusPrior_(target.radius) {
  restart({}, 0);
}

void BernoulliTrack::setTarget(const Target& target) {
  const bool radiusChanged = target.radius != target_.radius;
  target_ = target;
  if (radiusChanged) {
    radiusPrior_ = RadiusPrior(target.radius);
    for (TrackHypothesis& hypothesis : hypotheses_) {
      hypothesis.radius = target.radius > 0.0 ? target.radius : hypothesis.radius;
      hypothesis.logRadiusVariance = radiusPrior_.logVariance();
    }
  }
  predicted_ = hypotheses_;
}

void BernoulliTrack::restart(const StartVolume& start, std::uint64_t seed) {
  radiusPrior_.restart();
  searchPrior_.restart(bounds_ ? startVolumeWithin(start, *bounds_) : start);
  identityAmbiguity_ = 0.0;
  confidentBefore_ = 0;
  numbers_.restart();
  hypotheses_.clear();
  predicted_.clear();
  searchParticles_.restart(searchPrior_, settings_.maxParticles, {seed, 0, 0}, bounds_);
}

void BernoulliTrack::predict(double interval, const RandomKey& key) {
  confidentBefore_ = confidentHypothesis() != nullptr ? confidentHypothesis()->streamNumber : 0;
  const ConstantVelocity motion{interval, settings_.accelerationSigma};
  const double survival = std::exp(-interval / settings_.survivalSeconds);
  for (TrackHypothesis& hypothesis : hypotheses_) {
    dewpoint::tracking::predict(hypothesis, motion, key);
    hypothesis.probability *= survival;
    hypothesis.secondsSinceRimSeen += interval;
  }
  if (const TrackHypothesis* confirmed = confidentHypothesis();
      confirmed != nullptr && confirmed->hasRim()) {
    searchPrior_.confirmPosition(
        {confirmed->position(), confirmed->gaussian.covariance.topLeftCorner<3, 3>()});
  } else {
    searchPrior_.widen(interval, settings_.searchCubeEdge);
  }
  predicted_ = hypotheses_;
}

Eigen::Index BernoulliTrack::particleCount(const TrackHypothesis& hypothesis) const {
  if (settings_.kldError <= 0.0 || hypothesis.states.rows() == 0) {
    return settings_.maxParticles;
  }
  const auto bins = countOccupiedBins(hypothesis.states, kBinRadii * hypothesis.radius);
  return std::clamp(kldSampleSize(bins, settings_.kldError),
                    std::min(settings_.minParticles, settings_.maxParticles),
                    settings_.maxParticles);
}

void BernoulliTrack::update(SphereObservation& observation, const CandidateSource& search,
                            const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                            ThreadTeam& team) {
  hypotheses_ = predicted_;
  removeOccupied(occupied);
  if (hypotheses_.empty()) {
    identityAmbiguity_ = 0.0; // the next hypothesis is a new track
  }
  std::vector<double> logMasses;
  updateHypotheses(observation, key, team, logMasses);
  removeImpossible(logMasses);
  if (createsHypotheses_ && mustSearch(hypotheses_, logMasses)) {
    if (confidentHypothesis() == nullptr) {
      searchParticles_.update(searchPrior_, settings_.maxParticles, radiusPrior_.expectedRadius(),
                              bounds_, observation, key, team);
    }
    addNewHypotheses(observation, search, occupied, key, team, logMasses);
  }
  normalizeMasses(hypotheses_, logMasses);
  limitOneCameraHypotheses(hypotheses_);
  limitHypothesesWithoutRim(hypotheses_);
  mergeAndPrune(hypotheses_);
  if (const TrackHypothesis* sure = confidentHypothesis(); sure != nullptr && sure->isSaturated()) {
    radiusPrior_.learn(sure->radius, sure->logRadiusVariance);
  }
}

void BernoulliTrack::updateHypotheses(SphereObservation& observation, const RandomKey& key,
                                      ThreadTeam& team, std::vector<double>& logMasses) {
  for (TrackHypothesis& hypothesis : hypotheses_) {
    double factor =
        applyMeasurementUpdate(hypothesis, observation, particleCount(hypothesis), key, team);
    factor -= evidenceBeyondSaturation(hypothesis);
    hypothesis.onlyOneCameraSees =
        observation.cameraCount() > 1 &&
        observation.countCamerasInView(hypothesis.position(), hypothesis.velocity()) == 1;
    logMasses.push_back(std::log(std::max(priorProbability(hypothesis, observation), 1e-300)) +
                        factor);
  }
}

double BernoulliTrack::priorProbability(TrackHypothesis& hypothesis,
                                        SphereObservation& observation) const {
  observation.setRadius(hypothesis.radius);
  if (observation.isRimVisible(hypothesis.position(), hypothesis.velocity())) {
    hypothesis.wasRimSeen = true;
    hypothesis.secondsSinceRimSeen = 0.0;
  }
  // A part of something that stands still looks the same in every frame, and counts once.
  return hypothesis.wasRimSeen
             ? hypothesis.probability
             : std::min(hypothesis.probability,
                        birthProbability(hypothesis.position(), hypothesis.radius));
}

double BernoulliTrack::birthProbability(const Eigen::Vector3d& position, double radius) const {
  return kBirthProbability *
         searchPrior_.birthDensity(position, settings_.searchCubeEdge, bounds_) *
         constantLikelihoodVolume(radius);
}

void BernoulliTrack::removeImpossible(std::vector<double>& logMasses) {
  const std::size_t before = hypotheses_.size();
  for (std::size_t k = before; k-- > 0;) {
    const TrackHypothesis& one = hypotheses_[k];
    if ((bounds_ && !bounds_->contains(one.position(), one.radius)) ||
        !radiusPrior_.allowsRadius(one.radius)) {
      const auto at = static_cast<std::ptrdiff_t>(k);
      hypotheses_.erase(hypotheses_.begin() + at);
      logMasses.erase(logMasses.begin() + at);
    }
  }
  if (before > 0 && hypotheses_.empty()) {
    identityAmbiguity_ = 0.0; // the next hypothesis is a new track
  }
}

void BernoulliTrack::addNewHypotheses(SphereObservation& observation, const CandidateSource& search,
                                      const std::vector<OccupiedSphere>& occupied,
                                      const RandomKey& key, ThreadTeam& team,
                                      std::vector<double>& logMasses) {
  const bool radiusKnown = target_.radius > 0.0;
  observation.setRadius(target_.radius);
  const double absence = absenceProbabilityInSharedViews(hypotheses_);
  const bool first = hypotheses_.empty();
  for (const Candidate& candidate : search(observation, radiusKnown, kMaxCandidates)) {
    const OutlineFit fit =
        fitCandidateOutline(candidate, radiusPrior_, settings_.searchCubeEdge, observation);
    if (!fit.isFound) {
      continue;
    }
    observation.setRadius(fit.radius);
    if (observation.cameraCount() > 1 &&
        observation.countCamerasInView(fit.center, Eigen::Vector3d::Zero()) < 2) {
      continue; // one camera alone does not show where along its ray the target is
    }
    const double logLikelihoodRatio =
        observation.logLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
    const bool known = std::any_of(hypotheses_.begin(), hypotheses_.end(), [&](const auto& other) {
      return (other.position() - fit.center).norm() < fit.radius;
    });
    const double birth = birthProbability(fit.center, fit.radius);
    if (known || !radiusPrior_.allowsRadius(fit.radius) ||
        isOccupied(fit.center, fit.radius, occupied) ||
        logLikelihoodRatio < kMinLogLikelihoodRatio || birth <= 0.0) {
      continue;
    }
    hypotheses_.push_back(createHypothesis(fit, observation, key, team));
    logMasses.push_back(std::log(absence * birth) + logLikelihoodRatio -
                        evidenceBeyondSaturation(hypotheses_.back()) -
                        radiusPrior_.penaltyFor(fit.radius));
  }
  if (first) {
    scoreInitialHypotheses(observation, logMasses);
  }
}

void BernoulliTrack::scoreInitialHypotheses(SphereObservation& observation,
                                            std::vector<double>& logMasses) const {
  // Saturation protects a target that is partly hidden from a distractor that is not. Where nothing
  // is tracked yet there is nothing to protect, and what fits better is likelier to be the target.
  for (std::size_t k = 0; k < hypotheses_.size(); ++k) {
    const TrackHypothesis& one = hypotheses_[k];
    const double full = std::min(one.logLikelihoodRatio +
                                     logLikelihoodGainFromNeighbors(hypotheses_, k, observation),
                                 one.fullyVisibleLogLikelihoodRatio);
    const double size = 0.5 * std::min(one.sizeDeviation, kMaxSizeMisfit);
    logMasses[k] += full - size - (one.logLikelihoodRatio - evidenceBeyondSaturation(one));
  }
}

TrackHypothesis BernoulliTrack::newHypothesis(const Gaussian3& position, double radius,
                                              double logRadiusVariance) {
  TrackHypothesis hypothesis;
  hypothesis.streamNumber = numbers_.next();
  hypothesis.radius = radius;
  hypothesis.logRadiusVariance = logRadiusVariance;
  hypothesis.gaussian.mean << position.mean, Eigen::Vector3d::Zero();
  hypothesis.gaussian.covariance.setZero();
  hypothesis.gaussian.covariance.topLeftCorner<3, 3>() = position.covariance;
  hypothesis.gaussian.covariance.diagonal().tail<3>().setConstant(kBirthSpeed * kBirthSpeed);
  return hypothesis;
}

TrackHypothesis BernoulliTrack::createHypothesis(const OutlineFit& fit,
                                                 SphereObservation& observation,
                                                 const RandomKey& key, ThreadTeam& team) {
  TrackHypothesis hypothesis =
      newHypothesis({fit.center, fit.covariance}, fit.radius, fit.logRadiusVariance);
  observation.setRadius(fit.radius);
  hypothesis.logLikelihoodRatio =
      observation.logLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
  hypothesis.fullyVisibleLogLikelihoodRatio =
      observation.fullyVisibleLogLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
  hypothesis.wasOutlineFound = true;
  hypothesis.wasRimSeen = observation.isRimVisible(fit.center, Eigen::Vector3d::Zero());
  hypothesis.sizeDeviation = radiusPrior_.isTrusted() ? fit.sizeDeviation : 0.0;
  hypothesis.measurement = {fit.center, fit.covariance};
  sampleWeightedParticles(hypothesis, observation, settings_.minParticles, key, team);
  return hypothesis;
}

void BernoulliTrack::initializeAt(const Eigen::Vector3d& position, double radius,
                                  SphereObservation& observation, const RandomKey& key,
                                  ThreadTeam& team) {
  OutlineFit fit;
  fit.center = position;
  fit.radius = radius;
  fit.covariance =
      Eigen::Matrix3d::Identity() * (kInitialSigmaRadii * radius) * (kInitialSigmaRadii * radius);
  fit.logRadiusVariance = radiusPrior_.logVariance();
  hypotheses_.assign(1, createHypothesis(fit, observation, key, team));
  hypotheses_.front().probability = kInitialProbability;
  hypotheses_.front().lastSharedProbability = kInitialProbability;
  hypotheses_.front().wasRimSeen = true;
}

void BernoulliTrack::correct(const Gaussian3& position, SphereObservation& observation,
                             const RandomKey& key, ThreadTeam& team) {
  const double radius = mostLikelyHypothesis() != nullptr ? mostLikelyHypothesis()->radius
                                                          : radiusPrior_.expectedRadius();
  TrackHypothesis hypothesis = newHypothesis(position, radius, radiusPrior_.logVariance());
  hypothesis.probability = kInitialProbability;
  hypothesis.lastSharedProbability = kInitialProbability;
  hypothesis.wasRimSeen = true;
  hypothesis.givenCovariance = position.covariance;
  samplePriorParticles(hypothesis, settings_.maxParticles, key, team);
  predicted_.assign(1, hypothesis);
  confidentBefore_ = 0; // it may be anywhere
  applyMeasurementUpdate(hypothesis, observation, settings_.maxParticles, key, team);
  hypotheses_.assign(1, hypothesis);
  identityAmbiguity_ = 0.0;
}

void BernoulliTrack::setOnlyHypothesis(const TrackHypothesis* hypothesis) {
  hypotheses_.clear();
  if (hypothesis != nullptr) {
    hypotheses_.push_back(*hypothesis);
  }
  predicted_ = hypotheses_;
  identityAmbiguity_ = 0.0;
}

void BernoulliTrack::removeOccupied(const std::vector<OccupiedSphere>& occupied) {
  if (confidentHypothesis() != nullptr) {
    return;
  }
  const auto taken = [&](const TrackHypothesis& hypothesis) {
    return isOccupied(hypothesis.position(), hypothesis.radius, occupied);
  };
  std::erase_if(hypotheses_, taken);
  std::erase_if(predicted_, taken);
}

void BernoulliTrack::resolveIdentity(bool identicalTargets) {
  const auto ambiguity = resolveAmbiguity(hypotheses_);
  if (!ambiguity) {
    return;
  }
  if (!identicalTargets) {
    identityAmbiguity_ = std::max(identityAmbiguity_, *ambiguity);
  }
  const auto dropped = [&](const TrackHypothesis& other) {
    return std::none_of(hypotheses_.begin(), hypotheses_.end(), [&](const TrackHypothesis& left) {
      return left.streamNumber == other.streamNumber;
    });
  };
  std::erase_if(predicted_, dropped);
}

void BernoulliTrack::suppressBestHypothesis() {
  if (!hypotheses_.empty()) {
    hypotheses_.front().probability *= 1e-3;
    mergeAndPrune(hypotheses_);
  }
}

const TrackHypothesis* BernoulliTrack::mostLikelyHypothesis() const {
  return hypotheses_.empty() ? nullptr : &hypotheses_.front();
}

const TrackHypothesis* BernoulliTrack::confidentHypothesis() const {
  const TrackHypothesis* likeliest = mostLikelyHypothesis();
  return likeliest != nullptr && likeliest->probability > 0.5 ? likeliest : nullptr;
}

std::optional<OccupiedSphere> BernoulliTrack::expectedSphere() const {
  if (const TrackHypothesis* likeliest = mostLikelyHypothesis()) {
    return OccupiedSphere{likeliest->position(), likeliest->radius};
  }
  const auto last = searchPrior_.lastPosition();
  return last ? std::optional(OccupiedSphere{*last, radiusPrior_.expectedRadius()}) : std::nullopt;
}

bool BernoulliTrack::hasJumped() const {
  if (confidentBefore_ == 0 || hypotheses_.empty() ||
      hypotheses_.front().streamNumber == confidentBefore_) {
    return false;
  }
  const auto before =
      std::ranges::find(predicted_, confidentBefore_, &TrackHypothesis::streamNumber);
  return before != predicted_.end() &&
         (before->position() - hypotheses_.front().position()).norm() > before->radius;
}

SphereEstimate BernoulliTrack::estimate(SphereObservation& observation) const {
  const TrackHypothesis* likeliest = mostLikelyHypothesis();
  if (likeliest == nullptr || likeliest->states.rows() == 0) {
    return sphereEstimateFrom(searchParticles_);
  }
  SphereEstimate result =
      sphereEstimateFrom(*likeliest, identityAmbiguity_, settings_.systematicErrors, observation);
  const bool undecided = isUndecided(hypotheses_);
  result.isAmbiguous = undecided || identityAmbiguity_ >= kAmbiguousIdentity || hasJumped();
  if (undecided) {
    result.covariance +=
        mixtureCovariance(hypotheses_) - likeliest->gaussian.covariance.topLeftCorner<3, 3>();
  }
  return result;
}

void BernoulliTrack::copyParticles(int limit, Eigen::ArrayXXd& positions,
                                   Eigen::ArrayXd& weights) const {
  const TrackHypothesis* confirmed = confidentHypothesis();
  const Eigen::ArrayXXd& states =
      confirmed != nullptr ? confirmed->states : searchParticles_.states();
  const Eigen::ArrayXd& all =
      confirmed != nullptr ? confirmed->weights : searchParticles_.weights();
  pickEvenly(states, all, limit, 3, positions, weights);
}

std::size_t BernoulliTrack::memoryBytes() const {
  auto numbers = searchParticles_.states().size() + searchParticles_.weights().size();
  for (const auto* hypotheses : {&hypotheses_, &predicted_}) {
    for (const TrackHypothesis& hypothesis : *hypotheses) {
      numbers += hypothesis.states.size() + hypothesis.weights.size();
    }
  }
  return sizeof(double) * static_cast<std::size_t>(numbers);
}

} // namespace dewpoint::tracking
