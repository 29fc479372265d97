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

/// Hypothesis about a target's position: a cloud of particles, the Gaussian that summarizes the
/// cloud, and the probability that the target exists and is at this position. A cloud never spans
/// two positions: a target with several possible positions has several hypotheses (mixture
/// tracking: Vermaak, Doucet and Pérez 2003). World frame, meters, m/s.
struct TrackHypothesis {
  Eigen::ArrayXXd states;       ///< one row per particle: x y z vx vy vz
  Eigen::ArrayXd weights;       ///< weights of the particles, linear, sum 1
  Gaussian6 gaussian;           ///< Gaussian of position and velocity that summarizes the particles
  double radius = 0.0;          ///< radius of the target, meters
  double logRadiusVariance = 0; ///< variance of log(radius); 0: the radius is fixed
  double probability = 0.0;     ///< probability that the target exists and is at this position
  /// True if there are several cameras, but only one of them can see the target now.
  bool onlyOneCameraSees = false;
  /// `probability` at the time when more than one camera could last see the hypothesis.
  double lastSharedProbability = 0.0;
  /// True if a camera has shown the rim of the target (where its color ends) since the birth of the
  /// hypothesis, or the user has confirmed its position. Until then, the hypothesis may be part of
  /// a larger object.
  bool wasRimSeen = false;
  /// Time in seconds since the rim was last shown or the position was last confirmed.
  double secondsSinceRimSeen = 0.0;
  /// Log likelihood ratio at the last measurement update, sum over all cameras.
  double logLikelihoodRatio = 0.0;
  /// Log likelihood ratio that would result if every camera with the target in its image saw it
  /// fully.
  double fullyVisibleLogLikelihoodRatio = 0.0;
  /// Deviation of the outlines from their expected size when the hypothesis was created, if the
  /// radius is known (OutlineFit::sizeDeviation); otherwise 0.
  double sizeDeviation = 0.0;
  int updateCount = 0;          ///< frames with a measurement update since the birth
  bool wasOutlineFound = false; ///< true if the last measurement update found the outline
  /// Position (m, m²) from the last measurement update alone, without the prediction. Valid if
  /// `wasOutlineFound` is true.
  Gaussian3 measurement;
  /// Covariance (m²) of a position given by the user in this frame.
  std::optional<Eigen::Matrix3d> givenCovariance;
  AdaptiveProcessNoise processNoise;
  /// Disagreement between the cameras about the position (OutlineFit::disagreement) per degree of
  /// freedom, as a running mean. 1 if the cameras disagree as much as expected from the assumed
  /// edge errors.
  double meanCameraDisagreement = 1.0;
  /// Disagreement between the cameras per degree of freedom, and the information about the position
  /// from each camera, of the last measurement update that found an outline.
  double lastCameraDisagreement = 1.0;
  std::vector<CameraInformation> cameraInformation;
  /// Predictions not yet applied to the particles. While the outline is found, new particles are
  /// drawn, and these predictions are never needed.
  std::vector<std::pair<ConstantVelocity, RandomStream>> pendingPredictions;
  std::uint32_t streamNumber = 0; ///< number that gives each hypothesis different random numbers

  // Fractions of the fully visible log likelihood ratio. The values were chosen by judgment and not
  // measured (docs/method-dewpoint.md, sections 5 to 7).

  /// Fraction of the log likelihood ratio of a fully visible target; any excess over it is not
  /// counted. Small differences in fit between two nearly fully visible positions depend on light
  /// and pixels, and would accumulate from frame to frame.
  static constexpr double kSaturationShare = 0.75;
  /// Fraction of the log likelihood ratio of a fully visible target above which an object with the
  /// target's color and size is certainly there.
  static constexpr double kMostlyVisibleShare = 0.55;
  /// Fraction of the log likelihood ratio of a fully visible target above which at least a part of
  /// the target is visible.
  static constexpr double kPartlyVisibleShare = 0.25;

  /// Time in seconds for which a rim is remembered: about as long as a passing object covers a
  /// target.
  static constexpr double kRimMemorySeconds = 0.5;

  /// Returns whether the outline was found and the log likelihood ratio is at least
  /// kSaturationShare of its fully visible value. Between two such hypotheses, the likelihoods are
  /// not compared.
  bool isSaturated() const {
    return wasOutlineFound && fullyVisibleLogLikelihoodRatio > 0.0 &&
           logLikelihoodRatio >= kSaturationShare * fullyVisibleLogLikelihoodRatio;
  }

  /// Returns whether a camera showed the rim of the target recently, so that the hypothesis is not
  /// part of a larger object.
  bool hasRim() const { return wasRimSeen && secondsSinceRimSeen <= kRimMemorySeconds; }

  Eigen::Vector3d position() const { return gaussian.mean.head<3>(); }
  Eigen::Vector3d velocity() const { return gaussian.mean.tail<3>(); }
};

/// Two spheres of radii a and b conflict if the distance of their centers is below this fraction of
/// a + b. Real spheres cannot be closer than a + b, but estimates have small errors. The value was
/// chosen by judgment (docs/method-dewpoint.md, section 7).
inline constexpr double kTouching = 0.7;

/// Predicts a hypothesis over `allowed.interval` seconds, with at most the acceleration of
/// `allowed`. The probability of the hypothesis does not change.
void predict(TrackHypothesis& hypothesis, const ConstantVelocity& allowed, const RandomKey& key);

/// Draws `count` particles from the Gaussian of a hypothesis, without using images. Method:
/// importance sampling from a proposal that is wider than the Gaussian.
void samplePriorParticles(TrackHypothesis& hypothesis, Eigen::Index count, const RandomKey& key,
                          ThreadTeam& team);

/// Draws `count` particles from the Gaussian of a hypothesis and weights them with the likelihood
/// of the images. Method: importance sampling from a proposal that is wider than the Gaussian.
void sampleWeightedParticles(TrackHypothesis& hypothesis, SphereObservation& observation,
                             Eigen::Index count, const RandomKey& key, ThreadTeam& team);

/// Updates a hypothesis with the images of a frame. Fits the outline near the predicted position
/// and draws `count` particles from the posterior. If no outline is found, weights the predicted
/// particles by their likelihood, and resamples them if their effective sample size falls below
/// half. Returns the logarithm of the factor by which the odds of the hypothesis relative to
/// absence change.
double applyMeasurementUpdate(TrackHypothesis& hypothesis, SphereObservation& observation,
                              Eigen::Index count, const RandomKey& key, ThreadTeam& team);

/// Returns the amount by which the log likelihood ratio of hypothesis `own` increases if pixels
/// inside the outlines of the other mostly visible hypotheses do not count against `own`. A second
/// object of the same color that touches the target in an image is no evidence against the target.
double logLikelihoodGainFromNeighbors(const std::vector<TrackHypothesis>& all, std::size_t own,
                                      SphereObservation& observation);

/// Returns the volume in m³ over which the likelihood of a sphere of this radius (meters) is
/// approximately constant: a cube with edges of 0.3 radii.
double constantLikelihoodVolume(double radius);

} // namespace dewpoint::tracking
