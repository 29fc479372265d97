// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/bernoulli_track.h"

#include "core/filter/adaptive_size.h"
#include "core/filter/constant_velocity.h"
#include "core/filter/estimate.h"
#include "core/filter/isotropic_motion.h"
#include "core/filter/prepared_gaussian.h"
#include "core/filter/systematic_resampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

constexpr std::size_t kMaxCandidates = 10;
/// Probability that a target that is not there appears within one frame.
constexpr double kBirthProbability = 0.2;
/// Share of births near the place where the target is looked for first; the rest is anywhere.
constexpr double kSearchPriorShare = 0.5;
constexpr double kBirthSpeed = 1.5; ///< m/s, standard deviation along each axis
constexpr double kSearchPriorSpeed =
    0.5; ///< m/s at which the place to look for a lost target widens
constexpr double kMinSearchPriorSigma = 0.1;   ///< metres, at least
constexpr double kMinLogLikelihoodRatio = 2.0; ///< evidence worth a hypothesis
constexpr double kSearchMotionSigma = 0.03;    ///< metres per iteration of the search cloud
constexpr double kInitialProbability = 0.98;   ///< probability of a place that is given
/// An outline of another size speaks against a first place up to this many squared deviations.
constexpr double kMaxSizeMisfit = 20.0;
constexpr double kBinRadii = 0.5; ///< edge of the bins that particles are counted in
/// Relative standard deviation of a radius that is guessed from the images.
constexpr double kRadiusSigma = 0.2;

} // namespace

BernoulliTrack::BernoulliTrack(const Target& target) : target_(target) {
  restart({}, 0);
}

void BernoulliTrack::setTarget(const Target& target) {
  const bool radiusChanged = target.radius != target_.radius;
  target_ = target;
  for (TrackHypothesis& hypothesis : hypotheses_) {
    if (radiusChanged && target.radius > 0.0) {
      hypothesis.radius = target.radius;
    }
    hypothesis.logRadiusVariance = target.radius > 0.0 ? 0.0 : kRadiusSigma * kRadiusSigma;
  }
  predicted_ = hypotheses_;
}

void BernoulliTrack::restart(const StartVolume& start, std::uint64_t seed) {
  start_ = start;
  seed_ = seed;
  searchPrior_.mean = start.center;
  // A uniform distribution of half size h has the standard deviation h / sqrt(3).
  searchPrior_.covariance = (start.half / std::sqrt(3.0))
                                .array()
                                .max(kMinSearchPriorSigma)
                                .square()
                                .matrix()
                                .asDiagonal();
  everSeen_ = false;
  identityAmbiguity_ = 0.0;
  nextStream_ = 1;
  hypotheses_.clear();
  predicted_.clear();
  drawSearchCloud({seed, 0, 0});
}

void BernoulliTrack::drawSearchCloud(const RandomKey& key) {
  const RandomStream stream = key.stream(RandomPurpose::Start);
  if (everSeen_) {
    const PreparedGaussian3 anchor(searchPrior_);
    cloud_.states.resize(settings_.maxParticles, 3);
    for (Eigen::Index i = 0; i < cloud_.states.rows(); ++i) {
      const auto normal = stream.normal4(static_cast<std::uint32_t>(i));
      cloud_.states.row(i) =
          anchor.fromStandardNormal({normal[0], normal[1], normal[2]}).transpose();
    }
  } else {
    cloud_.states = drawUniformly(start_, settings_.maxParticles, stream);
  }
  cloud_.weights.setConstant(cloud_.states.rows(), 1.0 / static_cast<double>(cloud_.states.rows()));
}

void BernoulliTrack::predict(double interval, const RandomKey& key) {
  const ConstantVelocity motion{interval, settings_.accelerationSigma};
  const double survival = std::exp(-interval / settings_.survivalTime);
  for (TrackHypothesis& hypothesis : hypotheses_) {
    dewpoint::tracking::predict(hypothesis, motion, key);
    hypothesis.probability *= survival;
  }
  if (const TrackHypothesis* seen = confident()) {
    searchPrior_ = {seen->position(), seen->gaussian.covariance.topLeftCorner<3, 3>()};
    searchPrior_.covariance.diagonal().array() += kMinSearchPriorSigma * kMinSearchPriorSigma;
    everSeen_ = true;
  } else if (everSeen_) {
    // A standard deviation that grows linearly with time.
    const double sigma = std::sqrt(searchPrior_.covariance.trace() / 3.0);
    const double wider = std::min(sigma + kSearchPriorSpeed * interval, settings_.searchSize);
    searchPrior_.covariance *= (wider * wider) / (sigma * sigma);
  }
  predicted_ = hypotheses_;
}

Eigen::Index BernoulliTrack::particleCount(const TrackHypothesis& hypothesis) const {
  if (settings_.kldError <= 0.0 || hypothesis.states.rows() == 0) {
    return settings_.maxParticles;
  }
  const auto bins = occupiedBins(hypothesis.states, kBinRadii * hypothesis.radius);
  return std::clamp(kldSampleSize(bins, settings_.kldError),
                    std::min(settings_.minParticles, settings_.maxParticles),
                    settings_.maxParticles);
}

void BernoulliTrack::updateHypotheses(SphereObservation& observation, const RandomKey& key,
                                      ThreadTeam& team, std::vector<double>& logMasses) {
  for (TrackHypothesis& hypothesis : hypotheses_) {
    double factor =
        measurementUpdate(hypothesis, observation, particleCount(hypothesis), key, team);
    factor -= evidenceBeyondSaturation(hypothesis);
    logMasses.push_back(std::log(std::max(hypothesis.probability, 1e-300)) + factor);
  }
}

double BernoulliTrack::birthDensity(const Eigen::Vector3d& place) const {
  const double room = settings_.searchSize * settings_.searchSize * settings_.searchSize;
  double near = 0.0;
  if (everSeen_) {
    near = std::exp(PreparedGaussian3(searchPrior_).logDensity(place));
  } else {
    // Rather in the middle of the start box than near its walls: of two things that look the same,
    // the one nearer to where the user said is meant.
    const Eigen::Array3d sigma = (0.5 * start_.half.array()).max(0.5 * kMinSearchPriorSigma);
    const Eigen::Array3d off = (place - start_.center).array() / sigma;
    near = std::exp(-0.5 * off.square().sum()) /
           (std::pow(2.0 * std::numbers::pi, 1.5) * sigma.prod());
  }
  return kSearchPriorShare * near + (1.0 - kSearchPriorShare) / room;
}

TrackHypothesis BernoulliTrack::createHypothesis(const OutlineFit& fit,
                                                 SphereObservation& observation,
                                                 const RandomKey& key, ThreadTeam& team) {
  TrackHypothesis hypothesis;
  hypothesis.stream = nextStream_++ % 4096U;
  hypothesis.radius = fit.radius;
  hypothesis.logRadiusVariance = target_.radius > 0.0 ? 0.0 : fit.logRadiusVariance;
  hypothesis.gaussian.mean << fit.center, Eigen::Vector3d::Zero();
  hypothesis.gaussian.covariance.setZero();
  hypothesis.gaussian.covariance.topLeftCorner<3, 3>() = fit.covariance;
  hypothesis.gaussian.covariance.diagonal().tail<3>().setConstant(kBirthSpeed * kBirthSpeed);
  observation.setRadius(fit.radius);
  hypothesis.logLikelihoodRatio =
      observation.logLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
  hypothesis.fullyVisibleLogLikelihoodRatio =
      observation.fullyVisibleLogLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
  hypothesis.outlineFound = true;
  hypothesis.sizeMisfit = target_.radius > 0.0 ? fit.sizeMisfit : 0.0;
  hypothesis.measurement = {fit.center, fit.covariance};
  drawParticles(hypothesis, observation, settings_.minParticles, key, team);
  return hypothesis;
}

void BernoulliTrack::initializeAt(const Eigen::Vector3d& position, double radius,
                                  SphereObservation& observation, const RandomKey& key,
                                  ThreadTeam& team) {
  OutlineFit fit;
  fit.center = place;
  fit.radius = radius;
  fit.covariance = Eigen::Matrix3d::Identity() * (0.1 * radius) * (0.1 * radius);
  fit.logRadiusVariance = kRadiusSigma * kRadiusSigma;
  hypotheses_.assign(1, createHypothesis(fit, observation, key, team));
  hypotheses_.front().probability = kInitialProbability;
}

void BernoulliTrack::addBirths(SphereObservation& observation, const CandidateSource& search,
                               const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                               ThreadTeam& team, std::vector<double>& logMasses) {
  const bool radiusKnown = target_.radius > 0.0;
  observation.setRadius(target_.radius);
  const double birth = absenceProbability(hypotheses_) * kBirthProbability;
  const bool first = hypotheses_.empty();
  for (const Candidate& candidate : search(observation, radiusKnown, kMaxCandidates)) {
    OutlinePrior prior;
    prior.center = candidate.center;
    prior.radius = candidate.radius;
    prior.logRadiusVariance = radiusKnown ? 0.0 : kRadiusSigma * kRadiusSigma;
    prior.information = Eigen::Matrix3d::Identity() / (settings_.searchSize * settings_.searchSize);
    const OutlineFit fit = observation.fit(prior, Eigen::Vector3d::Zero());
    if (!fit.found) {
      continue;
    }
    observation.setRadius(fit.radius);
    const double logLikelihoodRatio =
        observation.logLikelihoodRatio(fit.center, Eigen::Vector3d::Zero());
    const bool known = std::any_of(hypotheses_.begin(), hypotheses_.end(), [&](const auto& other) {
      return (other.position() - fit.center).norm() < fit.radius;
    });
    if (known || isOccupied(fit.center, fit.radius, occupied) ||
        logLikelihoodRatio < kMinLogLikelihoodRatio) {
      continue;
    }
    hypotheses_.push_back(createHypothesis(fit, observation, key, team));
    logMasses.push_back(std::log(birth * birthDensity(fit.center) * evidenceVolume(fit.radius)) +
                        logLikelihoodRatio - evidenceBeyondSaturation(hypotheses_.back()));
  }
  if (first) {
    scoreInitialHypotheses(observation, logMasses);
  }
}

void BernoulliTrack::scoreInitialHypotheses(SphereObservation& observation,
                                            std::vector<double>& logMasses) const {
  // Saturation protects a target that is partly hidden from a look-alike that is not. Where nothing
  // is believed yet there is nothing to protect, and what fits better is likelier to be the target.
  for (std::size_t k = 0; k < hypotheses_.size(); ++k) {
    const TrackHypothesis& one = hypotheses_[k];
    const double full =
        std::min(one.logLikelihoodRatio + explainedRingGain(hypotheses_, k, observation),
                 one.fullyVisibleLogLikelihoodRatio);
    const double size = 0.5 * std::min(one.sizeMisfit, kMaxSizeMisfit);
    logMasses[k] += full - size - (one.logLikelihoodRatio - evidenceBeyondSaturation(one));
  }
}

void BernoulliTrack::update(SphereObservation& observation, const CandidateSource& search,
                            const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                            ThreadTeam& team) {
  hypotheses_ = predicted_;
  removeOccupied(occupied);
  if (hypotheses_.empty()) {
    identityAmbiguity_ = 0.0; // whatever comes is a new beginning
  }
  std::vector<double> logMasses;
  updateHypotheses(observation, key, team, logMasses);
  if (searching_ && mustSearch(hypotheses_, logMasses)) {
    stepSearchCloud(observation, key, team);
    addBirths(observation, search, occupied, key, team, logMasses);
  }
  normalizeMasses(hypotheses_, logMasses);
  mergeAndPrune(hypotheses_);
}

void BernoulliTrack::stepSearchCloud(SphereObservation& observation, const RandomKey& key,
                                     ThreadTeam& team) {
  if (confident() != nullptr) {
    return;
  }
  if (cloud_.states.rows() != settings_.maxParticles) {
    drawSearchCloud(key);
  }
  const RandomStream stream = key.stream(RandomPurpose::Search);
  Ancestors ancestors;
  SystematicResampling().ancestors(cloud_.weights, cloud_.states.rows(),
                                   key.streamOfPart(RandomPurpose::Resampling, 0), ancestors);
  cloud_.states = Eigen::ArrayXXd(cloud_.states(ancestors, Eigen::all));
  observation.setRadius(target_.radius > 0.0 ? target_.radius : 0.03);
  const IsotropicMotion motion{kSearchMotionSigma};
  team.forEachRange(cloud_.states.rows(), [&](std::int64_t begin, std::int64_t end) {
    motion.predict(cloud_.states.middleRows(begin, end - begin), static_cast<std::uint32_t>(begin),
                   stream);
  });
  const Eigen::ArrayXd logs = observation.logLikelihoods(cloud_.states, team);
  normalize(logs, cloud_.weights, team);
}

void BernoulliTrack::removeOccupied(const std::vector<OccupiedSphere>& occupied) {
  if (confident() != nullptr) {
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
    return std::none_of(hypotheses_.begin(), hypotheses_.end(),
                        [&](const TrackHypothesis& left) { return left.stream == other.stream; });
  };
  std::erase_if(predicted_, dropped);
}

void BernoulliTrack::suppressBest() {
  if (!hypotheses_.empty()) {
    hypotheses_.front().probability *= 1e-3;
    mergeAndPrune(hypotheses_);
  }
}

const TrackHypothesis* BernoulliTrack::best() const {
  return hypotheses_.empty() ? nullptr : &hypotheses_.front();
}

const TrackHypothesis* BernoulliTrack::confident() const {
  const TrackHypothesis* likeliest = best();
  return likeliest != nullptr && likeliest->probability > 0.5 ? likeliest : nullptr;
}

} // namespace dewpoint::tracking
