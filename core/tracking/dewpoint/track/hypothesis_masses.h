// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/track/track_hypothesis.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace dewpoint::tracking {

/// Sphere occupied by another target, which excludes other objects. Meters, world frame.
struct OccupiedSphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// Computations of the Bernoulli filter in the `dewpoint` method that work on hypotheses alone,
// without images. The mass of a hypothesis is its probability before the measurement, multiplied by
// the factor by which the measurement changes the odds of the hypothesis against absence of the
// target. The mass of absence is the probability of absence before the measurement. Masses are
// passed as logarithms, one per hypothesis, and do not sum to one.

/// Returns the probability that the target is at the position of none of these hypotheses. The
/// result is at least 1e-9, so that it has a logarithm.
double absenceProbability(const std::vector<TrackHypothesis>& hypotheses);

/// Returns the probability that the target is at the position of none of those hypotheses that more
/// than one camera can see now. A hypothesis that only one camera sees therefore does not prevent
/// the target from being found where two cameras see it.
double absenceProbabilityInSharedViews(const std::vector<TrackHypothesis>& hypotheses);

/// Limits the probability of each hypothesis that only one camera can see now. The limit is the
/// probability that the hypothesis had when more than one camera could last see it. A single camera
/// can therefore restore a hypothesis, but not make it more probable than before.
void limitOneCameraHypotheses(std::vector<TrackHypothesis>& hypotheses);

/// Limits the probability of a hypothesis to 0.9 if no camera has recently shown the rim of the
/// target (TrackHypothesis::hasRim()), because it may be part of a larger object.
void limitHypothesesWithoutRim(std::vector<TrackHypothesis>& hypotheses);

/// Returns the part of a hypothesis' log likelihood ratio that is not counted: the excess over
/// kSaturationShare times the log likelihood ratio of a fully visible target.
double evidenceBeyondSaturation(const TrackHypothesis& hypothesis);

/// Returns the probability of the most likely hypothesis among several that compete with each other
/// and with absence. The result is exp(largest m) / (absence + the sum of exp(m) over all m in
/// `logMasses`). `logMasses` must have at least one element. `absence` is the mass of absence
/// itself, not its logarithm.
double probabilityOfMostLikely(std::span<const double> logMasses, double absence);

/// Returns whether the images must be searched for the target, because there is no hypothesis or
/// the most likely hypothesis is doubtful. A hypothesis is doubtful if only one of several cameras
/// can see it, if it has less than 0.98 of all mass, or if its log likelihood ratio is less than
/// 0.55 of the value for a fully visible target.
bool mustSearch(const std::vector<TrackHypothesis>& hypotheses,
                const std::vector<double>& logMasses);

/// Sets the probability of each hypothesis to its mass divided by the sum of all masses, including
/// the mass of the target's absence. `logMasses` are the logarithms of the masses of the
/// hypotheses.
void normalizeMasses(std::vector<TrackHypothesis>& hypotheses,
                     const std::vector<double>& logMasses);

/// Returns whether the target is more likely than not at one of the hypotheses, but it is undecided
/// at which: other hypotheses fit about as well as the first (the most likely) hypothesis.
bool isUndecided(const std::vector<TrackHypothesis>& hypotheses);

/// Returns the covariance (m²) of the target's position for the mixture of all hypotheses, about
/// the position of the first hypothesis instead of the mean.
Eigen::Matrix3d mixtureCovariance(const std::vector<TrackHypothesis>& hypotheses);

/// Moves the most likely hypothesis to the front. Merges two hypotheses closer than half a radius
/// into the more likely of the two. Keeps at most six hypotheses, and none with a probability below
/// 1e-8.
void mergeAndPrune(std::vector<TrackHypothesis>& hypotheses);

/// Returns whether a sphere with this position and radius would overlap an occupied sphere. Two
/// spheres overlap if the distance of their centers is less than 0.7 times the sum of their radii.
/// The factor allows for errors of positions and radii.
bool isOccupied(const Eigen::Vector3d& position, double radius,
                const std::vector<OccupiedSphere>& occupied);

/// Keeps only the first (the most likely) of several hypotheses between which images cannot decide.
/// These are the hypotheses with at least five measurement updates for which isSaturated() is true.
/// The first of them receives the probabilities of the others, which are removed. Returns the
/// probability that this choice is wrong, or nothing if no choice was made.
std::optional<double> resolveAmbiguity(std::vector<TrackHypothesis>& hypotheses);

} // namespace dewpoint::tracking
