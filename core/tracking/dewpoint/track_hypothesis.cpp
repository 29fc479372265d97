// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track_hypothesis.h"

#include "core/filter/estimate.h"
#include "core/filter/prepared_gaussian.h"
#include "core/filter/systematic_resampling.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::tracking {
namespace {

/// The proposal is a little wider than the belief, and every seventh particle much wider, so that
/// no weight is huge where the belief's tails are too thin.
constexpr double kWider = 1.2;
constexpr Eigen::Index kWideEvery = 7;
constexpr double kWideShareOfRadius = 0.25;
/// An outline farther than this many standard deviations from the prediction is another thing's.
constexpr double kGate = 5.0;
/// Evidence alone, without an outline, tells places apart no better than this share of the radius:
/// the distance from its samples near the edge to the edge is twice that.
constexpr double kBluntShareOfRadius = 0.1;
/// A prediction wider than this share of the radius is looked for where its particles fit best.
constexpr double kWideOfRadius = 0.3;
/// Standard deviations from where it was expected after its motion of late that show that this
/// motion is over.
constexpr double kAbrupt = 4.0;
/// Evidence, as a share of the best, that shows that the target is at least partly seen.
constexpr double kPartlySeen = 0.25;
/// Evidence, as a share of the best, that leaves nothing to look for farther off.
constexpr double kClear = 0.7;
/// Evidence, as a share of the best, that shows that what a hypothesis covers is its own.
constexpr double kExplaining = 0.55;
/// Evidence of the five samples along one spoke and its opposite, which a straight edge that hides
/// half of the target takes or leaves together.
constexpr double kFewSamples = 6.0;
/// Rate at which disagreement between cameras is learned, and how much counts at most.
constexpr double kDisagreementRate = 0.2;
constexpr double kMostDisagreement = 1000.0;
/// An outline farther off must have this much more evidence.
constexpr double kWorthALeap = 3.0;
/// A moving ball is smeared over an exposure of usually about 10 ms; its outline is off by a share
/// of the way.
constexpr double kBlurSeconds = 0.0005;
/// The outline is known no better than this share of the radius: shading, color noise.
constexpr double kShareOfRadius = 0.003;

std::uint32_t firstIndex(const TrackHypothesis& hypothesis) {
  return hypothesis.stream << 20U;
}

double logSumOfTwo(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log(1.0 + std::exp(std::min(a, b) - larger));
}

/// The evidence of every particle.
Eigen::ArrayXd evidence(const TrackHypothesis& hypothesis, SphereObservation& observation,
                        ThreadTeam& team) {
  observation.setRadius(hypothesis.radius);
  return observation.logLikelihoods(hypothesis.states, team);
}

/// Moves the particles on to where the belief already is; left until they are needed.
void catchUp(TrackHypothesis& hypothesis, ThreadTeam& team) {
  for (const auto& step : hypothesis.pending) {
    const ConstantVelocity& motion = step.first;
    const RandomStream& stream = step.second;
    team.forEachRange(hypothesis.states.rows(), [&](std::int64_t begin, std::int64_t end) {
      motion.predict(hypothesis.states.middleRows(begin, end - begin),
                     firstIndex(hypothesis) + static_cast<std::uint32_t>(begin), stream);
    });
  }
  hypothesis.pending.clear();
}

void setBeliefFromParticles(TrackHypothesis& hypothesis) {
  const StateEstimate moments = estimate(hypothesis.states, hypothesis.weights);
  hypothesis.belief.mean = moments.mean;
  hypothesis.belief.covariance = moments.covariance;
  const double blunt = kBluntShareOfRadius * hypothesis.radius;
  hypothesis.belief.covariance.diagonal().head<3>().array() += blunt * blunt;
  // Never so narrow that it cannot be inverted.
  hypothesis.belief.covariance.diagonal().array() += 1e-10;
}

/// The look when no outline was found: the particles carry the belief alone.
double weighPrediction(TrackHypothesis& hypothesis, SphereObservation& observation,
                       const RandomKey& key, ThreadTeam& team) {
  catchUp(hypothesis, team);
  const Eigen::ArrayXd logs = evidence(hypothesis, observation, team);
  const double largest = logs.maxCoeff();
  const bool informative = largest - logs.minCoeff() > 1e-3;
  const Eigen::ArrayXd scaled = hypothesis.weights * (logs - largest).exp();
  const double sum = scaled.sum();
  if (informative && sum > 0.0) {
    hypothesis.weights = scaled / sum;
    setBeliefFromParticles(hypothesis);
    const double effective = 1.0 / hypothesis.weights.square().sum();
    const Eigen::Index count = hypothesis.states.rows();
    if (effective < 0.5 * static_cast<double>(count)) {
      Ancestors ancestors;
      SystematicResampling().ancestors(
          hypothesis.weights, count, key.streamOfPart(RandomPurpose::Resampling, hypothesis.stream),
          ancestors);
      hypothesis.states = Eigen::ArrayXXd(hypothesis.states(ancestors, Eigen::all));
      hypothesis.weights.setConstant(1.0 / static_cast<double>(count));
    }
  }
  hypothesis.logLikelihoodRatio =
      observation.logLikelihoodRatio(hypothesis.place(), hypothesis.velocity());
  return largest + std::log(std::max(sum, 1e-300));
}

/// A fitted outline, and whether it may be believed.
struct Measured {
  OutlineFit fit;
  Gaussian3 before; ///< what the fit took for known
  double logLikelihoodRatio = 0.0;
  bool accepted = false;
};

/// What is predicted, if the target moved as much as it may.
struct Prediction {
  Gaussian6::Matrix covariance; ///< of place and velocity
  Gaussian3 place;
  PreparedGaussian3 prepared;

  explicit Prediction(const TrackHypothesis& hypothesis)
      : covariance(hypothesis.belief.covariance + hypothesis.agility.margin()),
        place{hypothesis.place(), covariance.topLeftCorner<3, 3>()}, prepared(place) {}
};

Measured measure(const TrackHypothesis& hypothesis, SphereObservation& observation,
                 const Gaussian3& before, const Prediction& prediction, OutlineReach reach) {
  OutlinePrior prior;
  prior.center = before.mean;
  prior.radius = hypothesis.radius;
  prior.logRadiusVariance = hypothesis.logRadiusVariance;
  prior.information = before.covariance.inverse();
  Measured result{observation.fit(prior, hypothesis.velocity(), reach), before};
  if (!result.fit.found || prediction.prepared.squaredDistance(result.fit.center) > kGate * kGate) {
    return result;
  }
  observation.setRadius(result.fit.radius);
  result.logLikelihoodRatio =
      observation.logLikelihoodRatio(result.fit.center, hypothesis.velocity());
  observation.setRadius(hypothesis.radius);
  // An outline that explains the images worse than the prediction is an accident; but what is well
  // seen is well seen, a few samples more or less.
  const double expected = std::min(
      observation.logLikelihoodRatio(prior.center, hypothesis.velocity()),
      kClear * observation.fullyVisibleLogLikelihoodRatio(prior.center, hypothesis.velocity()));
  result.accepted =
      result.logLikelihoodRatio > 0.0 && result.logLikelihoodRatio >= expected - kFewSamples;
  return result;
}

/// Where a particle has the most evidence: a start for a fit when the prediction is wider than its
/// reach.
Gaussian3 likeliestStart(TrackHypothesis& hypothesis, SphereObservation& observation,
                         ThreadTeam& team) {
  catchUp(hypothesis, team);
  Eigen::Index top = 0;
  evidence(hypothesis, observation, team).maxCoeff(&top);
  const double radius = hypothesis.radius;
  return {hypothesis.states.row(top).head<3>().transpose(),
          radius * radius * Eigen::Matrix3d::Identity()};
}

/// Looks for the outline near the prediction, farther off if need be, and where a wide prediction's
/// particles see the target.
Measured findOutline(TrackHypothesis& hypothesis, SphereObservation& observation,
                     const Prediction& prediction, ThreadTeam& team) {
  Measured found =
      measure(hypothesis, observation, prediction.place, prediction, OutlineReach::Near);
  const double best =
      observation.fullyVisibleLogLikelihoodRatio(prediction.place.mean, hypothesis.velocity());
  const auto lookFrom = [&](const Gaussian3& before) {
    const Measured farther =
        measure(hypothesis, observation, before, prediction, OutlineReach::Far);
    if (farther.accepted &&
        (!found.accepted || farther.logLikelihoodRatio > found.logLikelihoodRatio + kWorthALeap)) {
      found = farther;
    }
  };
  if (!found.accepted || found.logLikelihoodRatio < kClear * best) {
    lookFrom(prediction.place);
  }
  const double wide = kWideOfRadius * hypothesis.radius;
  if (!found.accepted && hypothesis.states.rows() > 0 &&
      hypothesis.belief.covariance.topLeftCorner<3, 3>().trace() > 3.0 * wide * wide) {
    lookFrom(likeliestStart(hypothesis, observation, team));
  }
  return found;
}

/// The factor by which the covariance of an outline is larger than its edges say, as the cameras
/// disagree.
double widening(TrackHypothesis& hypothesis, const OutlineFit& fit) {
  if (fit.freedoms > 0) {
    const double now = std::min(fit.disagreement / fit.freedoms, kMostDisagreement);
    hypothesis.disagreement += kDisagreementRate * (now - hypothesis.disagreement);
  }
  return std::max(1.0, hypothesis.disagreement);
}

/// Conditions the belief on a fitted outline.
void conditionOn(TrackHypothesis& hypothesis, const Prediction& prediction, const Measured& found) {
  const double blur = kBlurSeconds * hypothesis.velocity().norm();
  const double shade = kShareOfRadius * hypothesis.radius;
  const InformationForm evidence =
      InformationForm::between(found.before, {found.fit.center, found.fit.covariance},
                               blur * blur + shade * shade)
          .seenFrom(hypothesis.place() - found.before.mean)
          .widened(widening(hypothesis, found.fit));
  hypothesis.seen = evidence.alone(hypothesis.place());
  const double off = evidence.squaredDistance(hypothesis.belief.covariance.topLeftCorner<3, 3>());
  if (off > kAbrupt * kAbrupt) {
    hypothesis.belief.covariance = prediction.covariance; // it moved as it had not before
  }
  condition(
      hypothesis.belief,
      evidence.after({hypothesis.place(), hypothesis.belief.covariance.topLeftCorner<3, 3>()}));
  hypothesis.agility.learn(off, hypothesis.velocity());
  hypothesis.agility.seen();
}

} // namespace

double explainedRingGain(const std::vector<TrackHypothesis>& all, std::size_t own,
                         SphereObservation& observation) {
  std::vector<OutlineSphere> others;
  for (std::size_t k = 0; k < all.size(); ++k) {
    // Against the best of this place: what one camera alone sees does not explain away another.
    if (k != own &&
        all[k].logLikelihoodRatio > kExplaining * all[own].fullyVisibleLogLikelihoodRatio) {
      others.push_back({all[k].place(), all[k].radius});
    }
  }
  observation.setRadius(all[own].radius);
  return observation.explainedRingGain(all[own].place(), others);
}

double evidenceVolume(double radius) {
  const double edge = 0.3 * radius;
  return edge * edge * edge;
}

void predict(TrackHypothesis& hypothesis, const ConstantVelocity& allowed, const RandomKey& key) {
  const ConstantVelocity motion = hypothesis.agility.next(allowed);
  motion.predict(hypothesis.belief);
  hypothesis.pending.emplace_back(motion, key.stream(RandomPurpose::Motion));
}

void drawParticles(TrackHypothesis& hypothesis, SphereObservation& observation, Eigen::Index count,
                   const RandomKey& key, ThreadTeam& team) {
  const Gaussian6& belief = hypothesis.belief;
  const Eigen::Matrix3d place = belief.covariance.topLeftCorner<3, 3>();
  const double wide = kWideShareOfRadius * hypothesis.radius;
  const PreparedGaussian3 posterior({belief.mean.head<3>(), place});
  const PreparedGaussian3 narrow({belief.mean.head<3>(), kWider * kWider * place});
  const PreparedGaussian3 broad(
      {belief.mean.head<3>(), place + wide * wide * Eigen::Matrix3d::Identity()});
  const Eigen::Matrix3d gain = belief.covariance.bottomLeftCorner<3, 3>() * place.inverse();
  Eigen::Matrix3d remaining =
      belief.covariance.bottomRightCorner<3, 3>() - gain * belief.covariance.topRightCorner<3, 3>();
  remaining.diagonal().array() += 1e-12;
  const PreparedGaussian3 velocity({Eigen::Vector3d::Zero(), remaining});
  const double broadShare = 1.0 / static_cast<double>(kWideEvery);
  const double logBroad = std::log(broadShare);
  const double logNarrow = std::log1p(-broadShare);

  hypothesis.pending.clear();
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
      stream.normals4(
          first + static_cast<std::uint32_t>(begin), block, end - begin,
          {column(k, begin), column(k + 1, begin), column(k + 2, begin), column(k + 3, begin)});
    }
    for (std::int64_t i = begin; i < end; ++i) {
      const auto a = normals.row(i).head<3>();
      const auto b = normals.row(i).segment<3>(4);
      const bool isBroad = i % kWideEvery == kWideEvery - 1;
      const Eigen::Vector3d x = (isBroad ? broad : narrow).place({a[0], a[1], a[2]});
      const Eigen::Vector3d v = belief.mean.tail<3>() + gain * (x - belief.mean.head<3>()) +
                                velocity.place({b[0], b[1], b[2]});
      hypothesis.states.row(i) << x.transpose().array(), v.transpose().array();
      const double proposal =
          logSumOfTwo(logNarrow + narrow.logDensity(x), logBroad + broad.logDensity(x));
      logs[i] = posterior.logDensity(x) - proposal;
    }
  });
  logs += evidence(hypothesis, observation, team);
  normalize(logs, hypothesis.weights, team);
}

double look(TrackHypothesis& hypothesis, SphereObservation& observation, Eigen::Index count,
            const RandomKey& key, ThreadTeam& team) {
  ++hypothesis.looks;
  observation.setRadius(hypothesis.radius);
  const Prediction prediction(hypothesis);
  const Measured found = findOutline(hypothesis, observation, prediction, team);
  const OutlineFit& fit = found.fit;
  hypothesis.measured = found.accepted;
  hypothesis.logLikelihoodRatio = found.logLikelihoodRatio;
  if (!hypothesis.measured) {
    const double factor = weighPrediction(hypothesis, observation, key, team);
    hypothesis.fullyVisibleLogLikelihoodRatio =
        observation.fullyVisibleLogLikelihoodRatio(hypothesis.place(), hypothesis.velocity());
    if (hypothesis.fullyVisibleLogLikelihoodRatio > 0.0 &&
        hypothesis.logLikelihoodRatio > kPartlySeen * hypothesis.fullyVisibleLogLikelihoodRatio) {
      hypothesis.agility.seen();
    } else {
      hypothesis.agility.notSeen();
    }
    return factor;
  }
  hypothesis.radius = fit.radius;
  if (hypothesis.logRadiusVariance > 0.0) {
    hypothesis.logRadiusVariance = std::max(fit.logRadiusVariance, 1e-6);
  }
  // Three standard deviations are as good as none: otherwise a thing at rest would slowly win
  // against one that moves.
  const double surprise =
      std::max(0.0, 0.5 * (prediction.prepared.squaredDistance(fit.center) - 9.0));
  conditionOn(hypothesis, prediction, found);
  hypothesis.fullyVisibleLogLikelihoodRatio =
      observation.fullyVisibleLogLikelihoodRatio(hypothesis.place(), hypothesis.velocity());
  drawParticles(hypothesis, observation, count, key, team);
  return hypothesis.logLikelihoodRatio - surprise;
}

} // namespace dewpoint::tracking
