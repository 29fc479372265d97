// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/track_hypothesis.h"

#include "core/filter/estimate.h"
#include "core/filter/prepared_gaussian.h"
#include "core/filter/systematic_resampling.h"
#include "core/tracking/dewpoint/track/information_form.h"
#include "core/tracking/dewpoint/track/track_constants.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 3; those without a derivation are judgments.

// The proposal is a little wider than the posterior, and every seventh particle is drawn from a
// much wider one, so that no weight is huge where the posterior's tails are too thin.
constexpr double kWider = 1.2;              ///< factor of the standard deviations
constexpr Eigen::Index kWideEvery = 7;      ///< particles
constexpr double kWideShareOfRadius = 0.25; ///< radii, added standard deviation
/// Radii, standard deviation with which the likelihood alone, without an outline, tells positions
/// apart: half the distance from the samples near the edge to the edge.
constexpr double kBluntShareOfRadius = 0.1;
/// Radii; a fit also starts from the best particle when the prediction is less certain than this.
constexpr double kWideOfRadius = 0.3;
/// Share of the fully visible evidence that leaves no need for a fit with farther edges.
constexpr double kNoFarFitShare = 0.7;
/// Log likelihood ratio of the five samples along one spoke and its opposite (5 x 1.08 and a
/// little), which a straight edge that hides half of the target covers or uncovers together.
constexpr double kSampleTolerance = 6.0;
/// Gain of the running mean of the cameras' disagreement, per measurement update, 0 to 1.
constexpr double kDisagreementRate = 0.2;
/// Largest disagreement per degree of freedom that counts.
constexpr double kMaxDisagreement = 1000.0;
/// By this much the log likelihood ratio of a fit with farther edges must be larger.
constexpr double kFarFitMinGain = 3.0;
/// Seconds. An exposure of about 10 ms smears a moving ball; its outline is off by a share of the
/// way.
constexpr double kBlurSeconds = 0.0005;
/// Radii, least standard deviation of an outline's center: shading, color noise.
constexpr double kShadingShareOfRadius = 0.003;

/// Standard deviation by which the logarithm of a radius that is measured becomes less certain with
/// each frame: one that was mistaken is left behind within seconds.
constexpr double kRadiusDrift = 0.001;
constexpr double kWidestRadius = 0.2; ///< standard deviation that it reaches at most
/// A radius that is known as well as this (standard deviation of its logarithm) stays while one
/// camera of several alone sees the outline.
constexpr double kHeldRadius = 0.05;

/// Index of its first particle in the random streams, which all hypotheses of a target share.
std::uint32_t firstIndex(const TrackHypothesis& hypothesis) {
  return hypothesis.streamNumber << 20U;
}

double logSumOfTwo(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log(1.0 + std::exp(std::min(a, b) - larger));
}

/// The log likelihood ratio of every particle.
Eigen::ArrayXd logLikelihoods(const TrackHypothesis& hypothesis, SphereObservation& observation,
                              ThreadTeam& team) {
  observation.setRadius(hypothesis.radius);
  return observation.logLikelihoods(hypothesis.states, team);
}

/// Makes the predictions of the particles that were put off until the particles are needed.
void applyPendingMotion(TrackHypothesis& hypothesis, ThreadTeam& team) {
  for (const auto& step : hypothesis.pendingPredictions) {
    const ConstantVelocity& motion = step.first;
    const RandomStream& stream = step.second;
    team.forEachRange(hypothesis.states.rows(), [&](std::int64_t begin, std::int64_t end) {
      motion.predict(hypothesis.states.middleRows(begin, end - begin),
                     firstIndex(hypothesis) + static_cast<std::uint32_t>(begin), stream);
    });
  }
  hypothesis.pendingPredictions.clear();
}

/// Moments of the particles, no narrower than the likelihood can tell positions apart.
void setGaussianFromParticles(TrackHypothesis& hypothesis) {
  const StateEstimate moments = estimate(hypothesis.states, hypothesis.weights);
  hypothesis.gaussian.mean = moments.mean;
  hypothesis.gaussian.covariance = moments.covariance;
  const double blunt = kBluntShareOfRadius * hypothesis.radius;
  hypothesis.gaussian.covariance.diagonal().head<3>().array() += blunt * blunt;
  // Never so narrow that it cannot be inverted.
  hypothesis.gaussian.covariance.diagonal().array() += 1e-10;
}

/// The measurement update when no outline was found: weights the predicted particles. Returns the
/// log factor of applyMeasurementUpdate().
double weightPrediction(TrackHypothesis& hypothesis, SphereObservation& observation,
                        const RandomKey& key, ThreadTeam& team) {
  applyPendingMotion(hypothesis, team);
  const Eigen::ArrayXd logs = logLikelihoods(hypothesis, observation, team);
  const double largest = logs.maxCoeff();
  const bool informative = largest - logs.minCoeff() > 1e-3;
  const Eigen::ArrayXd scaled = hypothesis.weights * (logs - largest).exp();
  const double sum = scaled.sum();
  if (informative && sum > 0.0) {
    hypothesis.weights = scaled / sum;
    setGaussianFromParticles(hypothesis);
    const double effective = 1.0 / hypothesis.weights.square().sum();
    const Eigen::Index count = hypothesis.states.rows();
    if (effective < 0.5 * static_cast<double>(count)) {
      Ancestors ancestors;
      SystematicResampling().drawAncestors(
          hypothesis.weights, count,
          key.streamOfPart(RandomPurpose::Resampling, hypothesis.streamNumber), ancestors);
      hypothesis.states = Eigen::ArrayXXd(hypothesis.states(ancestors, Eigen::all));
      hypothesis.weights.setConstant(1.0 / static_cast<double>(count));
    }
  }
  hypothesis.logLikelihoodRatio =
      observation.logLikelihoodRatio(hypothesis.position(), hypothesis.velocity());
  return largest + std::log(std::max(sum, 1e-300));
}

/// A fitted outline, and whether it is accepted as the target's.
struct OutlineMeasurement {
  OutlineFit fit;
  Gaussian3 prior; ///< position that the fit started from
  double logLikelihoodRatio = 0.0;
  bool accepted = false;
};

/// The prediction used for gating: the target may have accelerated as much as is allowed.
struct Prediction {
  Gaussian6::Matrix covariance; ///< of position and velocity
  Gaussian3 position;
  PreparedGaussian3 prepared;

  explicit Prediction(const TrackHypothesis& hypothesis)
      : covariance(hypothesis.gaussian.covariance + hypothesis.processNoise.gatingCovariance()),
        position{hypothesis.position(), covariance.topLeftCorner<3, 3>()}, prepared(position) {}
};

OutlineMeasurement measure(const TrackHypothesis& hypothesis, SphereObservation& observation,
                           const Gaussian3& before, const Prediction& prediction,
                           EdgeSearchRange reach) {
  OutlinePrior prior;
  prior.center = before.mean;
  prior.radius = hypothesis.radius;
  prior.logRadiusVariance = hypothesis.logRadiusVariance;
  prior.information = before.covariance.inverse();
  OutlineMeasurement result{observation.fit(prior, hypothesis.velocity(), reach), before};
  if (result.fit.isFound && result.fit.degreesOfFreedom == 0 && prior.logRadiusVariance > 0.0 &&
      prior.logRadiusVariance < kHeldRadius * kHeldRadius && observation.cameraCount() > 1) {
    // One camera alone does not tell a larger target from a nearer one: the radius stays, and how
    // well it is known counts in the covariance (a Schmidt-Kalman update).
    const OutlineFit free = std::exchange(result.fit, {});
    prior.logRadiusVariance = 0.0;
    result.fit = observation.fit(prior, hypothesis.velocity(), reach);
    result.fit.covariance = free.covariance;
    result.fit.logRadiusVariance = hypothesis.logRadiusVariance;
  }
  if (!result.fit.isFound ||
      prediction.prepared.squaredDistance(result.fit.center) > kGate * kGate) {
    return result;
  }
  observation.setRadius(result.fit.radius);
  result.logLikelihoodRatio =
      observation.logLikelihoodRatio(result.fit.center, hypothesis.velocity());
  observation.setRadius(hypothesis.radius);
  // An outline that explains the images worse than the prediction is an accident, but a few samples
  // more or less say nothing.
  const double expected =
      std::min(observation.logLikelihoodRatio(prior.center, hypothesis.velocity()),
               kNoFarFitShare *
                   observation.fullyVisibleLogLikelihoodRatio(prior.center, hypothesis.velocity()));
  result.accepted =
      result.logLikelihoodRatio > 0.0 && result.logLikelihoodRatio >= expected - kSampleTolerance;
  return result;
}

/// The likeliest particle: a start for a fit when the prediction is wider than the fit's reach.
Gaussian3 startAtBestParticle(TrackHypothesis& hypothesis, SphereObservation& observation,
                              ThreadTeam& team) {
  applyPendingMotion(hypothesis, team);
  Eigen::Index top = 0;
  logLikelihoods(hypothesis, observation, team).maxCoeff(&top);
  const double radius = hypothesis.radius;
  return {hypothesis.states.row(top).head<3>().transpose(),
          radius * radius * Eigen::Matrix3d::Identity()};
}

/// Fits the outline with edges near the prediction, with farther ones if need be, and, where the
/// prediction is wide, from its best particle.
OutlineMeasurement findOutline(TrackHypothesis& hypothesis, SphereObservation& observation,
                               const Prediction& prediction, ThreadTeam& team) {
  OutlineMeasurement found =
      measure(hypothesis, observation, prediction.position, prediction, EdgeSearchRange::Near);
  const double best =
      observation.fullyVisibleLogLikelihoodRatio(prediction.position.mean, hypothesis.velocity());
  const auto fitFrom = [&](const Gaussian3& before) {
    const OutlineMeasurement farther =
        measure(hypothesis, observation, before, prediction, EdgeSearchRange::Far);
    if (farther.accepted && (!found.accepted || farther.logLikelihoodRatio >
                                                    found.logLikelihoodRatio + kFarFitMinGain)) {
      found = farther;
    }
  };
  if (!found.accepted || found.logLikelihoodRatio < kNoFarFitShare * best) {
    fitFrom(prediction.position);
  }
  const double wide = kWideOfRadius * hypothesis.radius;
  if (!found.accepted && hypothesis.states.rows() > 0 &&
      hypothesis.gaussian.covariance.topLeftCorner<3, 3>().trace() > 3.0 * wide * wide) {
    fitFrom(startAtBestParticle(hypothesis, observation, team));
  }
  return found;
}

/// Updates the cameras' disagreement; returns the factor, at least 1, by which the covariance of an
/// outline is larger than the assumed errors of its edges say.
double updateDisagreement(TrackHypothesis& hypothesis, const OutlineFit& fit) {
  if (fit.degreesOfFreedom > 0) {
    const double now = std::min(fit.disagreement / fit.degreesOfFreedom, kMaxDisagreement);
    hypothesis.lastCameraDisagreement = now;
    hypothesis.meanCameraDisagreement +=
        kDisagreementRate * (now - hypothesis.meanCameraDisagreement);
  }
  return std::max(1.0, hypothesis.meanCameraDisagreement);
}

/// Conditions the Gaussian on a fitted outline (the update of a Kalman filter, in information
/// form).
void conditionOnOutline(TrackHypothesis& hypothesis, const Prediction& prediction,
                        const OutlineMeasurement& found) {
  const double blur = kBlurSeconds * hypothesis.velocity().norm();
  const double shade = kShadingShareOfRadius * hypothesis.radius;
  const InformationForm evidence =
      InformationForm::measurementBetween(found.prior, {found.fit.center, found.fit.covariance},
                                          blur * blur + shade * shade)
          .relativeTo(hypothesis.position() - found.prior.mean)
          .inflated(updateDisagreement(hypothesis, found.fit));
  hypothesis.measurement = evidence.asGaussian(hypothesis.position());
  const double off =
      evidence.squaredMahalanobisDistance(hypothesis.gaussian.covariance.topLeftCorner<3, 3>());
  if (off > kManeuverGate * kManeuverGate) {
    hypothesis.gaussian.covariance = prediction.covariance; // a maneuver
  }
  conditionOnPosition(hypothesis.gaussian,
                      evidence.posterior({hypothesis.position(),
                                          hypothesis.gaussian.covariance.topLeftCorner<3, 3>()}));
  hypothesis.cameraInformation = found.fit.cameraInformation;
  hypothesis.processNoise.learn(off, hypothesis.velocity());
  hypothesis.processNoise.recordSeen();
}

} // namespace

double logLikelihoodGainFromNeighbors(const std::vector<TrackHypothesis>& all, std::size_t own,
                                      SphereObservation& observation) {
  std::vector<OutlineSphere> others;
  for (std::size_t k = 0; k < all.size(); ++k) {
    // Compared with what this hypothesis can have at most: an object that one camera alone sees
    // does not explain away another.
    if (k != own && all[k].logLikelihoodRatio > TrackHypothesis::kMostlyVisibleShare *
                                                    all[own].fullyVisibleLogLikelihoodRatio) {
      others.push_back({all[k].position(), all[k].radius});
    }
  }
  observation.setRadius(all[own].radius);
  return observation.explainedRingGain(all[own].position(), others);
}

double constantLikelihoodVolume(double radius) {
  const double edge = 0.3 * radius;
  return edge * edge * edge;
}

void predict(TrackHypothesis& hypothesis, const ConstantVelocity& allowed, const RandomKey& key) {
  const ConstantVelocity motion = hypothesis.processNoise.nextMotion(allowed);
  motion.predict(hypothesis.gaussian);
  hypothesis.givenCovariance.reset();
  // One camera alone does not tell a larger target from a nearer one.
  if (hypothesis.logRadiusVariance > 0.0 && !hypothesis.onlyOneCameraSees &&
      hypothesis.logRadiusVariance < kWidestRadius * kWidestRadius) {
    hypothesis.logRadiusVariance += kRadiusDrift * kRadiusDrift;
  }
  hypothesis.pendingPredictions.emplace_back(motion, key.stream(RandomPurpose::Motion));
}

namespace {

/// Draws particles from a proposal that is wider than the hypothesis' Gaussian; their log weights.
Eigen::ArrayXd propose(TrackHypothesis& hypothesis, Eigen::Index count, const RandomKey& key,
                       ThreadTeam& team) {
  const Gaussian6& gaussian = hypothesis.gaussian;
  const Eigen::Matrix3d positionCovariance = gaussian.covariance.topLeftCorner<3, 3>();
  const double wide = kWideShareOfRadius * hypothesis.radius;
  const PreparedGaussian3 posterior({gaussian.mean.head<3>(), positionCovariance});
  const PreparedGaussian3 narrow({gaussian.mean.head<3>(), kWider * kWider * positionCovariance});
  const PreparedGaussian3 broad(
      {gaussian.mean.head<3>(), positionCovariance + wide * wide * Eigen::Matrix3d::Identity()});
  const Eigen::Matrix3d gain =
      gaussian.covariance.bottomLeftCorner<3, 3>() * positionCovariance.inverse();
  Eigen::Matrix3d remaining = gaussian.covariance.bottomRightCorner<3, 3>() -
                              gain * gaussian.covariance.topRightCorner<3, 3>();
  remaining.diagonal().array() += 1e-12;
  const PreparedGaussian3 velocity({Eigen::Vector3d::Zero(), remaining});
  const double broadShare = 1.0 / static_cast<double>(kWideEvery);
  const double logBroad = std::log(broadShare);
  const double logNarrow = std::log1p(-broadShare);

  hypothesis.pendingPredictions.clear();
  hypothesis.states.resize(count, 6);
  Eigen::ArrayXd logs(count);
  const RandomStream stream = key.stream(RandomPurpose::Proposal);
  const std::uint32_t first = firstIndex(hypothesis);
  Eigen::ArrayXXd normals(count, 8);
  const auto column = [&](Eigen::Index k, std::int64_t begin) {
    return normals.col(k).data() + begin;
  };
  team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (const std::uint32_t block : {0U, 1U}) {
      const Eigen::Index k = 4 * static_cast<Eigen::Index>(block);
      stream.fillNormal4(
          first + static_cast<std::uint32_t>(begin), block, end - begin,
          {column(k, begin), column(k + 1, begin), column(k + 2, begin), column(k + 3, begin)});
    }
    for (std::int64_t i = begin; i < end; ++i) {
      const auto a = normals.row(i).head<3>();
      const auto b = normals.row(i).segment<3>(4);
      const bool isBroad = i % kWideEvery == kWideEvery - 1;
      const Eigen::Vector3d x = (isBroad ? broad : narrow).fromStandardNormal({a[0], a[1], a[2]});
      const Eigen::Vector3d v = gaussian.mean.tail<3>() + gain * (x - gaussian.mean.head<3>()) +
                                velocity.fromStandardNormal({b[0], b[1], b[2]});
      hypothesis.states.row(i) << x.transpose().array(), v.transpose().array();
      const double proposal =
          logSumOfTwo(logNarrow + narrow.logDensity(x), logBroad + broad.logDensity(x));
      logs[i] = posterior.logDensity(x) - proposal;
    }
  });
  return logs;
}

} // namespace

void samplePriorParticles(TrackHypothesis& hypothesis, Eigen::Index count, const RandomKey& key,
                          ThreadTeam& team) {
  const Eigen::ArrayXd logs = propose(hypothesis, count, key, team);
  normalize(logs, hypothesis.weights, team);
}

void sampleWeightedParticles(TrackHypothesis& hypothesis, SphereObservation& observation,
                             Eigen::Index count, const RandomKey& key, ThreadTeam& team) {
  Eigen::ArrayXd logs = propose(hypothesis, count, key, team);
  logs += logLikelihoods(hypothesis, observation, team);
  normalize(logs, hypothesis.weights, team);
}

double applyMeasurementUpdate(TrackHypothesis& hypothesis, SphereObservation& observation,
                              Eigen::Index count, const RandomKey& key, ThreadTeam& team) {
  ++hypothesis.updateCount;
  observation.setRadius(hypothesis.radius);
  const Prediction prediction(hypothesis);
  const OutlineMeasurement found = findOutline(hypothesis, observation, prediction, team);
  const OutlineFit& fit = found.fit;
  hypothesis.wasOutlineFound = found.accepted;
  hypothesis.logLikelihoodRatio = found.logLikelihoodRatio;
  if (!hypothesis.wasOutlineFound) {
    const double factor = weightPrediction(hypothesis, observation, key, team);
    hypothesis.fullyVisibleLogLikelihoodRatio =
        observation.fullyVisibleLogLikelihoodRatio(hypothesis.position(), hypothesis.velocity());
    if (hypothesis.fullyVisibleLogLikelihoodRatio > 0.0 &&
        hypothesis.logLikelihoodRatio >
            TrackHypothesis::kPartlyVisibleShare * hypothesis.fullyVisibleLogLikelihoodRatio) {
      hypothesis.processNoise.recordSeen();
    } else {
      hypothesis.processNoise.recordUnseen();
    }
    return factor;
  }
  hypothesis.radius = fit.radius;
  if (hypothesis.logRadiusVariance > 0.0) {
    hypothesis.logRadiusVariance = std::max(fit.logRadiusVariance, 1e-6);
  }
  // Up to three standard deviations cost nothing: otherwise an object at rest would slowly win
  // against one that moves.
  const double innovationPenalty =
      std::max(0.0, 0.5 * (prediction.prepared.squaredDistance(fit.center) - 9.0));
  conditionOnOutline(hypothesis, prediction, found);
  hypothesis.fullyVisibleLogLikelihoodRatio =
      observation.fullyVisibleLogLikelihoodRatio(hypothesis.position(), hypothesis.velocity());
  sampleWeightedParticles(hypothesis, observation, count, key, team);
  return hypothesis.logLikelihoodRatio - innovationPenalty;
}

} // namespace dewpoint::tracking
