// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/constant_velocity.h"
#include "core/filter/gaussian.h"
#include "core/filter/particle_filter.h"
#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/adaptive_process_noise.h"

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// One place where a target may be: a cloud of particles, a Gaussian that sums it up, and the
/// probability that this is where the target is. A cloud never spans two places: a target that may
/// be in several has several hypotheses (mixture tracking: Vermaak, Doucet and Pérez 2003).
struct TrackHypothesis {
  Eigen::ArrayXXd states;          ///< one row per particle: x y z vx vy vz
  Eigen::ArrayXd weights;          ///< linear, sum 1
  Gaussian6 belief;                ///< the same as a Gaussian
  double radius = 0.0;             ///< metres
  double logRadiusVariance = 0;    ///< 0 when the radius is known
  double probability = 0.0;        ///< that the target is here
  double logLikelihoodRatio = 0.0; ///< evidence of the last look, all cameras
  double fullyVisibleLogLikelihoodRatio =
      0.0;                      ///< what it would be if every camera there saw it fully
  double sizeMisfit = 0.0;      ///< OutlineFit's when it was first found, if the radius is known
  int looks = 0;                ///< frames it has been looked at
  bool measured = false;        ///< the outline was found at the last look
  Gaussian3 seen;               ///< if so, what that look alone says of the place
  AdaptiveProcessNoise agility; ///< how it has moved of late
  /// By how much the cameras have disagreed of late, against what is assumed of an outline's edges.
  double disagreement = 1.0;
  /// Steps of motion that the particles have yet to make: they are not needed while the outline is
  /// found, because new ones are drawn then.
  std::vector<std::pair<ConstantVelocity, RandomStream>> pending;
  std::uint32_t stream = 0; ///< sets its random numbers apart from other hypotheses'

  /// Whether the outline was found and nearly all of it is seen (kSaturation). Between two such
  /// hypotheses the evidence does not decide.
  bool wellSeen() const {
    return measured && fullyVisibleLogLikelihoodRatio > 0.0 &&
           logLikelihoodRatio >= kSaturation * fullyVisibleLogLikelihoodRatio;
  }
  /// Share of the best evidence above which it is all the same: how much better one well seen place
  /// looks than another is a matter of light and pixels, and would add up from frame to frame.
  static constexpr double kSaturation = 0.75;

  /// Share of the best evidence that leaves no doubt that something of its looks is there.
  static constexpr double kPlainlySeen = 0.55;

  Eigen::Vector3d place() const { return belief.mean.head<3>(); }
  Eigen::Vector3d velocity() const { return belief.mean.tail<3>(); }
};

/// Two spheres of radii a and b cannot be closer than a + b; estimates may err a little, so that
/// only those closer than this share of it are in each other's place.
inline constexpr double kTouching = 0.7;

/// Moves a hypothesis on by one step, with at most the acceleration `allowed`.
void predict(TrackHypothesis& hypothesis, const ConstantVelocity& allowed, const RandomKey& key);

/// Draws the particles of a hypothesis from its belief: the importance sampling of a wider
/// proposal, weighted by the evidence at each particle. `count` particles.
void drawParticles(TrackHypothesis& hypothesis, SphereObservation& observation, Eigen::Index count,
                   const RandomKey& key, ThreadTeam& team);

/// One look at the images: finds the outline near the predicted place and conditions the belief on
/// it; where there is none, weighs the predicted particles as they are, and resamples them when
/// their effective number falls below half. Returns the log of the factor by which the look changes
/// the hypothesis's probability against "not there".
double look(TrackHypothesis& hypothesis, SphereObservation& observation, Eigen::Index count,
            const RandomKey& key, ThreadTeam& team);

/// By how much the log likelihood ratio of hypothesis `own` rises when pixels in the outlines of
/// the other well seen hypotheses are not counted against it: a second target of the same color
/// behind its rim then does not speak against it.
double explainedRingGain(const std::vector<TrackHypothesis>& all, std::size_t own,
                         SphereObservation& observation);

/// The volume, in m³, within which a sphere of this radius has about the same evidence.
double evidenceVolume(double radius);

} // namespace dewpoint::tracking
