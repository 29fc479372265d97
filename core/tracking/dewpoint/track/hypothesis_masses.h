// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/track/track_hypothesis.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace dewpoint::tracking {

/// A sphere that another target occupies: nothing else can be there. Meters, world frame.
struct OccupiedSphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// The arithmetic of the Bernoulli filter of method `dewpoint`, on hypotheses as values: no images.
// The mass of a hypothesis is its probability before the measurement times the factor by which the
// measurement changes it against "not there"; "not there" itself keeps its probability. Masses are
// passed as logarithms, one per hypothesis, and do not sum to one.

/// Probability that the target is at none of these positions; at least 1e-9, so that it has a
/// logarithm.
double absenceProbability(const std::vector<TrackHypothesis>& hypotheses);

/// Probability that the target is at none of the positions that more than one camera can see now:
/// what one camera alone shows does not keep the target from being found where two show it.
double absenceFromSharedViews(const std::vector<TrackHypothesis>& hypotheses);

/// Takes from each hypothesis that one camera alone can see now what it has gained since more than
/// one could: one camera's evidence counts up to its prior.
void limitOneCamera(std::vector<TrackHypothesis>& hypotheses);

/// What may be a part of something larger (TrackHypothesis::hasRim() is false) is not stated with
/// more than 0.9.
void limitWithoutRim(std::vector<TrackHypothesis>& hypotheses);

/// The part of the log likelihood ratio above TrackHypothesis::kSaturationShare, which does not
/// count.
double evidenceBeyondSaturation(const TrackHypothesis& hypothesis);

/// Probability of the likeliest of some hypotheses, which compete with each other and with "not
/// there": exp(m) / (absence + the sum of exp(m) over all). `logMasses`: at least one; `absence` is
/// linear. Of several that are equal the first counts as the likeliest and the rest as its rivals.
double shareOfLargest(std::span<const double> logMasses, double absence);

/// Whether the images have to be searched for the target: the likeliest hypothesis has less than
/// 0.98 of all mass, or less than 0.55 of the evidence it would have if it were fully seen, or
/// there is none.
bool mustSearch(const std::vector<TrackHypothesis>& hypotheses,
                const std::vector<double>& logMasses);

/// Sets the probabilities to the masses divided by their sum, absence included.
void normalizeMasses(std::vector<TrackHypothesis>& hypotheses,
                     const std::vector<double>& logMasses);

/// Whether hypotheses other than the first, the likeliest, fit about as well, if it is likelier
/// than not that the target is at one of them.
bool isUndecided(const std::vector<TrackHypothesis>& hypotheses);

/// Covariance (m²) of the target's position about that of the first hypothesis, by all of them:
/// their mixture.
Eigen::Matrix3d mixtureCovariance(const std::vector<TrackHypothesis>& hypotheses);

/// Puts the likeliest first, adds the probability of those closer than half a radius to the
/// likelier one, and keeps at most six, none less likely than 1e-8.
void mergeAndPrune(std::vector<TrackHypothesis>& hypotheses);

/// Whether a sphere of this position and radius would overlap an occupied one: spheres of radii a
/// and b cannot be closer than a + b; 0.7 of that is allowed for errors of both.
bool isOccupied(const Eigen::Vector3d& position, double radius,
                const std::vector<OccupiedSphere>& occupied);

/// Takes the likeliest of several positions for the target when it and others have been fully seen
/// for five frames: the images will never tell which it is. The others' probability goes to it.
/// Returns the probability that this was wrong; nothing when there was nothing to decide.
std::optional<double> resolveAmbiguity(std::vector<TrackHypothesis>& hypotheses);

} // namespace dewpoint::tracking
