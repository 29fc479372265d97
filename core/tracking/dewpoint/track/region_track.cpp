// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/region_track.h"

#include "core/filter/prepared_gaussian.h"
#include "core/tracking/dewpoint/search/region_search.h"
#include "core/tracking/dewpoint/track/information_form.h"
#include "core/tracking/dewpoint/track/track_constants.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 12), where no other source is named.

constexpr std::size_t kMaxRegionCandidates = 4; ///< per search
/// Probability above which another object is not searched for.
constexpr double kRegionNoSearchProbability = 0.5;
/// Standard deviation of the extent from frame to frame, as a share of its trace: a stick that
/// tumbles once in four seconds changes by 0.05 in a thirtieth of one. And at a birth.
constexpr double kExtentSigma = 0.06;
constexpr double kNewExtentSigma = 1.0;
/// Gains of the running means, per update.
constexpr double kRegionDisagreementRate = 0.1;
constexpr double kFillRate = 0.1;
constexpr double kMaxRegionDisagreement = 100.0;
/// Share of its outline that a target fills, before it is known.
constexpr double kPriorFill = 0.75;
/// Probability below which a hypothesis is given up.
constexpr double kMinRegionProbability = 1e-3;

double logLikelihoodRatio(const std::vector<RegionMeasurement>& views, double fill) {
  double sum = 0.0;
  for (const RegionMeasurement& view : views) {
    sum += view.isInView ? regionEvidence(view, fill) : 0.0;
  }
  return sum;
}

double fullyVisible(const std::vector<RegionMeasurement>& views) {
  double sum = 0.0;
  for (const RegionMeasurement& view : views) {
    sum += view.isInView ? fullRegionEvidence() : 0.0;
  }
  return sum;
}

/// Evidence counts up to the share that it does for a ball.
double saturated(const TrackHypothesis& hypothesis) {
  return std::min(hypothesis.logLikelihoodRatio,
                  TrackHypothesis::kSaturationShare * hypothesis.fullyVisibleLogLikelihoodRatio);
}

int viewsInView(const std::vector<RegionMeasurement>& views) {
  return static_cast<int>(
      std::ranges::count_if(views, [](const RegionMeasurement& view) { return view.isInView; }));
}

} // namespace

void RegionTrack::restart(const StartVolume& start) {
  searchPrior_.restart(bounds_ ? startVolumeWithin(start, *bounds_) : start);
  numbers_.restart();
  discardHypothesis();
}

void RegionTrack::discardHypothesis() {
  state_.reset();
  predicted_.reset();
}

void RegionTrack::predict(double interval, const RandomKey& key) {
  if (state_) {
    TrackHypothesis& hypothesis = state_->hypothesis;
    dewpoint::tracking::predict(hypothesis, {interval, settings_.accelerationSigma}, key);
    hypothesis.probability *= std::exp(-interval / settings_.survivalSeconds);
    hypothesis.pendingPredictions.clear(); // particles are drawn anew in each update
  }
  if (state_ && state_->hypothesis.probability > kRegionNoSearchProbability) {
    const TrackHypothesis& sure = state_->hypothesis;
    searchPrior_.confirmPosition({sure.position(), sure.gaussian.covariance.topLeftCorner<3, 3>()});
  } else {
    searchPrior_.widen(interval, settings_.searchCubeEdge);
  }
  predicted_ = state_;
}

RegionTrack::State RegionTrack::newState(const Gaussian3& position, const Eigen::Matrix3d& extent) {
  State state;
  TrackHypothesis& hypothesis = state.hypothesis;
  hypothesis.streamNumber = numbers_.next();
  hypothesis.gaussian.mean << position.mean, Eigen::Vector3d::Zero();
  hypothesis.gaussian.covariance.setZero();
  hypothesis.gaussian.covariance.topLeftCorner<3, 3>() = position.covariance;
  hypothesis.gaussian.covariance.diagonal().tail<3>().setConstant(kBirthSpeed * kBirthSpeed);
  state.extent = extent;
  hypothesis.radius = Ellipsoid{position.mean, extent}.radius();
  return state;
}

EllipsoidFit RegionTrack::fitAt(const State& state, RegionObservation& observation) const {
  const TrackHypothesis& hypothesis = state.hypothesis;
  EllipsoidPrior prior;
  prior.ellipsoid = {hypothesis.position(), state.extent};
  prior.information =
      Eigen::Matrix3d((hypothesis.gaussian.covariance + hypothesis.processNoise.gatingCovariance())
                          .topLeftCorner<3, 3>())
          .inverse();
  prior.velocity = hypothesis.velocity();
  // The mean of the first measurements, then one that forgets.
  prior.extentSigma =
      std::max(kExtentSigma, kNewExtentSigma / std::pow(1.0 + hypothesis.updateCount, 2));
  return fitEllipsoid(observation, prior);
}

void RegionTrack::accept(State& state, const EllipsoidFit& fit) const {
  TrackHypothesis& hypothesis = state.hypothesis;
  if (fit.degreesOfFreedom > 0) {
    const double now = std::min(fit.disagreement / fit.degreesOfFreedom, kMaxRegionDisagreement);
    state.meanCameraDisagreement += kRegionDisagreementRate * (now - state.meanCameraDisagreement);
  }
  state.extent = fit.ellipsoid.extent;
  hypothesis.radius = Ellipsoid{fit.ellipsoid.center, state.extent}.radius();
  const Gaussian6::Matrix wide =
      hypothesis.gaussian.covariance + hypothesis.processNoise.gatingCovariance();
  const Gaussian3 prior{hypothesis.position(), wide.topLeftCorner<3, 3>()};
  InformationForm evidence;
  evidence.information = fit.information + kMinInformation * Eigen::Matrix3d::Identity();
  evidence.vector = fit.covariance.inverse() * (fit.ellipsoid.center - prior.mean);
  hypothesis.measurement = evidence.asGaussian(prior.mean);
  const double off =
      evidence.squaredMahalanobisDistance(hypothesis.gaussian.covariance.topLeftCorner<3, 3>());
  if (off > kManeuverGate * kManeuverGate) {
    hypothesis.gaussian.covariance = wide;
  }
  conditionOnPosition(hypothesis.gaussian,
                      evidence.posterior({hypothesis.position(),
                                          hypothesis.gaussian.covariance.topLeftCorner<3, 3>()}));
  hypothesis.processNoise.learn(off, hypothesis.velocity());
}

double RegionTrack::measure(State& state, RegionObservation& observation) const {
  TrackHypothesis& hypothesis = state.hypothesis;
  const EllipsoidFit fit = fitAt(state, observation);
  ++hypothesis.updateCount;
  state.measurements = fit.views;
  const Gaussian6::Matrix wide =
      hypothesis.gaussian.covariance + hypothesis.processNoise.gatingCovariance();
  const PreparedGaussian3 gate({hypothesis.position(), wide.topLeftCorner<3, 3>()});
  hypothesis.wasOutlineFound =
      fit.isFound && gate.squaredDistance(fit.ellipsoid.center) <= kGate * kGate;
  const double fill = state.coloredFraction > 0.0 ? state.coloredFraction : kPriorFill;
  hypothesis.logLikelihoodRatio = logLikelihoodRatio(state.measurements, fill);
  hypothesis.fullyVisibleLogLikelihoodRatio = fullyVisible(state.measurements);
  hypothesis.onlyOneCameraSees =
      observation.cameraCount() > 1 && viewsInView(state.measurements) == 1;
  if (hypothesis.wasOutlineFound) {
    accept(state, fit);
    for (const RegionMeasurement& view : state.measurements) {
      if (view.region && view.visibleShare > 0.5) {
        state.coloredFraction =
            state.coloredFraction > 0.0
                ? state.coloredFraction + kFillRate * (view.matchedShare - state.coloredFraction)
                : view.matchedShare;
      }
    }
  }
  if (hypothesis.logLikelihoodRatio >
          TrackHypothesis::kPartlyVisibleShare * hypothesis.fullyVisibleLogLikelihoodRatio &&
      hypothesis.wasOutlineFound) {
    hypothesis.processNoise.recordSeen();
  } else {
    hypothesis.processNoise.recordUnseen();
  }
  return saturated(hypothesis);
}

void RegionTrack::draw(const RandomKey& key, ThreadTeam& team) {
  if (state_) {
    samplePriorParticles(state_->hypothesis, settings_.minParticles, key, team);
  }
}

void RegionTrack::startAt(const Gaussian3& position, const Eigen::Matrix3d& extent, bool byHand,
                          RegionObservation& observation, const RandomKey& key, ThreadTeam& team) {
  State state = newState(position, extent);
  state.hypothesis.probability = kInitialProbability;
  state.hypothesis.lastSharedProbability = kInitialProbability;
  if (byHand) {
    state.hypothesis.givenCovariance = position.covariance;
  }
  predicted_ = state;
  measure(state, observation);
  state_ = state;
  draw(key, team);
}

void RegionTrack::update(RegionObservation& observation,
                         const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                         ThreadTeam& team) {
  state_ = predicted_;
  if (state_) {
    TrackHypothesis& hypothesis = state_->hypothesis;
    const double before = std::clamp(hypothesis.probability, kMinAbsence, 1.0 - kMinAbsence);
    const double odds = std::log(before / (1.0 - before)) + measure(*state_, observation);
    hypothesis.probability = probabilityFromLogOdds(odds);
    if (hypothesis.onlyOneCameraSees) {
      hypothesis.probability = std::min(hypothesis.probability, hypothesis.lastSharedProbability);
    } else {
      hypothesis.lastSharedProbability = hypothesis.probability;
    }
    const bool outside = bounds_ && !bounds_->contains(hypothesis.position(), hypothesis.radius);
    if (hypothesis.probability < kMinRegionProbability || outside) {
      state_.reset();
    }
  }
  if (!state_ || state_->hypothesis.probability < kRegionNoSearchProbability) {
    search(observation, occupied);
  }
  draw(key, team);
}

void RegionTrack::search(RegionObservation& observation,
                         const std::vector<OccupiedSphere>& occupied) {
  const double present = state_ ? state_->hypothesis.probability : 0.0;
  std::optional<State> best;
  double bestMass = 0.0;
  double allMass = std::max(kMinAbsence, 1.0 - present) + present;
  for (const RegionCandidate& candidate :
       findRegionCandidates(observation, target_.radius, bounds_, kMaxRegionCandidates)) {
    if (isOccupied(candidate.center, candidate.radius, occupied)) {
      continue;
    }
    const double sigma = candidate.radius;
    State state = newState({candidate.center, sigma * sigma * Eigen::Matrix3d::Identity()},
                           ballExtent(candidate.radius));
    measure(state, observation);
    const TrackHypothesis& found = state.hypothesis;
    const double density =
        searchPrior_.birthDensity(found.position(), settings_.searchCubeEdge, bounds_);
    if (!found.wasOutlineFound || found.onlyOneCameraSees || density <= 0.0 ||
        found.logLikelihoodRatio < kMinLogLikelihoodRatio) {
      continue;
    }
    const double mass = std::exp(std::log((1.0 - present) * kBirthProbability * density *
                                          constantLikelihoodVolume(candidate.radius)) +
                                 saturated(found) + candidate.logRarity - 0.5 * candidate.misfit);
    allMass += mass;
    if (mass > bestMass) {
      bestMass = mass;
      best = state;
    }
  }
  if (!best || bestMass / allMass <= std::max(present, kMinRegionProbability)) {
    return;
  }
  const double absence = std::max(kMinAbsence, 1.0 - present);
  const double others = std::max(0.0, allMass - bestMass - absence - present);
  best->ambiguity = others / (others + bestMass);
  best->hypothesis.probability = bestMass / (bestMass + absence + present);
  best->hypothesis.lastSharedProbability = best->hypothesis.probability;
  state_ = best;
}

double RegionTrack::longestAxis() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(state_->extent, Eigen::EigenvaluesOnly);
  return std::sqrt(axes.eigenvalues().maxCoeff());
}

SphereEstimate RegionTrack::estimate(const RegionObservation& observation) const {
  const State& state = *state_;
  std::vector<CameraEvidence> cameras(observation.cameraCount());
  std::vector<Eigen::Vector3d> seeing;
  const double fill = state.coloredFraction > 0.0 ? state.coloredFraction : kPriorFill;
  for (std::size_t k = 0; k < std::min(cameras.size(), state.measurements.size()); ++k) {
    const RegionMeasurement& view = state.measurements[k];
    CameraEvidence& camera = cameras[k];
    camera.isInView = view.isInView;
    camera.logLikelihood = view.isInView ? regionEvidence(view, fill) : 0.0;
    camera.existenceProbability = probabilityFromLogOdds(camera.logLikelihood);
    camera.visibleShare = std::min(1.0, view.visibleShare * view.matchedShare / fill);
    if (view.isInView && view.region && camera.visibleShare >= kSeenShare) {
      seeing.push_back(observation.views()[k].projector.cameraCenter());
    }
  }
  // Second moments of a solid are a fifth of its extent, of its image a quarter: kShapeShare is of
  // the image's.
  const Eigen::Matrix3d ofShape =
      kShapeShare * kShapeShare * std::max(1.0, state.meanCameraDisagreement) * 0.25 * state.extent;
  SphereEstimate result =
      estimateFrom(state.hypothesis, state.ambiguity, seeing, settings_.systematicErrors, ofShape);
  result.seeingCameraCount = SphereObservation::countSeeingCameras(cameras);
  result.cameras = std::move(cameras);
  result.extent = state.extent;
  return result;
}

std::size_t RegionTrack::memoryBytes() const {
  const auto bytesOf = [](const std::optional<State>& state) {
    return state ? sizeof(double) * static_cast<std::size_t>(state->hypothesis.states.size() +
                                                             state->hypothesis.weights.size())
                 : 0U;
  };
  return bytesOf(state_) + bytesOf(predicted_);
}

} // namespace dewpoint::tracking
