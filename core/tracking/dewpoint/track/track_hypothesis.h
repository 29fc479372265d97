// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/constant_velocity.h"
#include "core/filter/gaussian.h"
#include "core/filter/particle_filter.h"
#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/track/adaptive_process_noise.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// One position at which a target may be: a cloud of particles, the Gaussian that summarizes it,
/// and the probability that the target exists and is there. A cloud never spans two positions: a
/// target that may be at several has several hypotheses (mixture tracking: Vermaak, Doucet and
/// Pérez 2003). World frame, meters, m/s.
struct TrackHypothesis {
  Eigen::ArrayXXd states;       ///< one row per particle: x y z vx vy vz
  Eigen::ArrayXd weights;       ///< linear, sum 1
  Gaussian6 gaussian;           ///< position and velocity
  double radius = 0.0;          ///< meters
  double logRadiusVariance = 0; ///< of log(radius); 0: the radius stays as it is
  double probability = 0.0;     ///< that the target exists and is here
  /// Whether one camera of several alone can see it now.
  bool oneCameraOnly = false;
  /// Its probability when more than one camera could see it last.
  double provenProbability = 0.0;
  /// Whether a camera has shown its rim since the birth, or somebody said that it is here: until
  /// then it may be a part of something larger.
  bool rimSeen = false;
  double secondsSinceRim = 0.0;    ///< since that was shown or said last
  double logLikelihoodRatio = 0.0; ///< at the last measurement update, sum over all cameras
  /// The log likelihood ratio if every camera in whose image the target lies saw it fully.
  double fullyVisibleLogLikelihoodRatio = 0.0;
  double sizeMisfit = 0.0;   ///< OutlineFit's at the birth, if the radius is known; else 0
  int updateCount = 0;       ///< frames with a measurement update since the birth
  bool outlineFound = false; ///< at the last measurement update
  /// If so, the position (m, m²) by that measurement alone, without the prediction.
  Gaussian3 measurement;
  /// Covariance (m²) of a position that somebody gave by hand in this frame.
  std::optional<Eigen::Matrix3d> given;
  AdaptiveProcessNoise processNoise;
  /// Running mean of OutlineFit::disagreement per degree of freedom: 1 when the cameras disagree as
  /// much as the assumed errors of the edges explain.
  double disagreement = 1.0;
  /// Predictions that the particles have not made yet: while the outline is found new particles are
  /// drawn, and these are never needed.
  std::vector<std::pair<ConstantVelocity, RandomStream>> pending;
  std::uint32_t stream = 0; ///< keeps its random numbers apart from those of other hypotheses

  // Shares of the fully visible log likelihood ratio. Judgments, not measurements
  // (docs/method-dewpoint.md, sections 5 to 7).

  /// Evidence above this share does not count: how much better one nearly fully visible position
  /// fits than another depends on light and pixels, and would add up from frame to frame.
  static constexpr double kSaturationShare = 0.75;
  /// Above this share an object with the target's color and size is there without doubt.
  static constexpr double kMostlyVisibleShare = 0.55;
  /// Above this share at least a part of the target is seen.
  static constexpr double kPartlyVisibleShare = 0.25;

  /// Seconds that a rim is remembered: as long as a target is covered in passing.
  static constexpr double kRimMemory = 0.5;

  /// Whether the outline was found and the evidence has reached kSaturationShare. The evidence does
  /// not decide between two such hypotheses.
  bool isSaturated() const {
    return outlineFound && fullyVisibleLogLikelihoodRatio > 0.0 &&
           logLikelihoodRatio >= kSaturationShare * fullyVisibleLogLikelihoodRatio;
  }

  /// Whether its rim was shown not long ago, so that it is no part of something larger.
  bool hasRim() const { return rimSeen && secondsSinceRim <= kRimMemory; }

  Eigen::Vector3d position() const { return gaussian.mean.head<3>(); }
  Eigen::Vector3d velocity() const { return gaussian.mean.tail<3>(); }
};

/// Two spheres of radii a and b cannot be closer than a + b. Estimates err a little: only spheres
/// closer than this share of a + b conflict with each other. A judgment
/// (docs/method-dewpoint.md, section 7).
inline constexpr double kTouching = 0.7;

/// Predicts a hypothesis over `allowed.interval` seconds, with at most the acceleration of
/// `allowed`. Its probability does not change.
void predict(TrackHypothesis& hypothesis, const ConstantVelocity& allowed, const RandomKey& key);

/// Draws `count` particles from the Gaussian of a hypothesis alone, before any image counts:
/// importance sampling from a proposal that is wider than the Gaussian.
void drawPrior(TrackHypothesis& hypothesis, Eigen::Index count, const RandomKey& key,
               ThreadTeam& team);

/// Draws `count` particles for the Gaussian of a hypothesis: importance sampling from a proposal
/// that is wider than the Gaussian, weighted by the likelihood at each particle.
void drawParticles(TrackHypothesis& hypothesis, SphereObservation& observation, Eigen::Index count,
                   const RandomKey& key, ThreadTeam& team);

/// Conditions a hypothesis on the images of a frame. Fits the outline near the predicted position
/// and draws `count` particles from the posterior; where no outline is found, weights the predicted
/// particles by their likelihood, and resamples them when their effective number falls below half.
/// Returns the logarithm of the factor by which the odds of the hypothesis against "not there"
/// change.
double measurementUpdate(TrackHypothesis& hypothesis, SphereObservation& observation,
                         Eigen::Index count, const RandomKey& key, ThreadTeam& team);

/// The increase of the log likelihood ratio of hypothesis `own` when pixels inside the outlines of
/// the other mostly visible hypotheses are not counted against it: a second object of the same
/// color that touches it in an image is no evidence against it.
double explainedRingGain(const std::vector<TrackHypothesis>& all, std::size_t own,
                         SphereObservation& observation);

/// The volume, in m³, over which the likelihood of a sphere of this radius (meters) is about
/// constant: a cube with edges of 0.3 radii.
double evidenceVolume(double radius);

} // namespace dewpoint::tracking
