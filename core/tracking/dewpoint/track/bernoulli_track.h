// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/search_particles.h"
#include "core/tracking/dewpoint/search/search_prior.h"
#include "core/tracking/dewpoint/track/hypothesis_estimate.h"
#include "core/tracking/dewpoint/track/hypothesis_masses.h"
#include "core/tracking/dewpoint/track/hypothesis_numbers.h"
#include "core/tracking/dewpoint/track/radius_prior.h"
#include "core/tracking/dewpoint/track/track_hypothesis.h"
#include "core/tracking/start_parameters.h"
#include "core/tracking/target.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Parameters from dewpointParameters() that a track depends on.
struct BernoulliTrackSettings {
  Eigen::Index maxParticles = 500;
  Eigen::Index minParticles = 100;
  /// Maximum Kullback-Leibler divergence of the particles; 0: use maxParticles.
  double kldError = 0.1;
  /// Standard deviation of the acceleration, m/s². The caller must set this value.
  double accelerationSigma = 0.0;
  double survivalSeconds = 5.0; ///< seconds for which an unseen target still counts as present
  double searchCubeEdge = 4.0;  ///< edge length of the space in which a target may appear, meters
  SystematicErrors systematicErrors; ///< systematic errors included in estimates
};

/// Finds candidate positions of the target in the images of an observation; see
/// CandidateSearch::find().
using CandidateSource = std::function<std::vector<Candidate>(SphereObservation& observation,
                                                             bool radiusKnown, std::size_t limit)>;

/// Track of one target: its existence probability and its possible positions. The track is a
/// Bernoulli filter (Ristic, Vo, Vo and Farina 2013) whose spatial density is a mixture of
/// hypotheses, each about one position. In each frame, hypotheses survive, are updated with the
/// images, and compete with each other, with new hypotheses from the images, and with absence of
/// the target. New hypotheses take their probability only from the probability of absence, so a
/// target that is clearly visible does not jump to a distractor. World frame, meters.
class BernoulliTrack {
public:
  explicit BernoulliTrack(const Target& target);

  void configure(const BernoulliTrackSettings& settings) { settings_ = settings; }
  /// Sets whether the track creates hypotheses from the images (true by default). If false, the
  /// track ends with its last hypothesis.
  void setCreatesHypotheses(bool creates) { createsHypotheses_ = creates; }
  void setTarget(const Target& target);
  /// Limits the positions of the target. Without a value, positions are unlimited. The bounds apply
  /// to hypotheses from the next update on, and to the start volume and the search particles from
  /// the next restart on.
  void setBounds(const std::optional<WorldBox>& bounds) { bounds_ = bounds; }
  /// Removes all hypotheses. The target is then expected in the start volume first, and elsewhere
  /// later.
  void restart(const StartVolume& start, std::uint64_t seed);

  /// Predicts all hypotheses over `interval` seconds. Call this function once per frame.
  void predict(double interval, const RandomKey& key);
  /// Updates the track with the images of the frame. A second update in the same frame starts from
  /// the prediction again, so no measurement counts twice.
  void update(SphereObservation& observation, const CandidateSource& search,
              const std::vector<OccupiedSphere>& occupied, const RandomKey& key, ThreadTeam& team);
  /// Replaces all hypotheses by one hypothesis at this position (meters, world frame), with
  /// probability 0.98.
  void initializeAt(const Eigen::Vector3d& position, double radius, SphereObservation& observation,
                    const RandomKey& key, ThreadTeam& team);
  /// Corrects the position (m, m²). Replaces all hypotheses by one hypothesis with probability 0.98
  /// and the current radius, and updates this hypothesis with the images of the frame.
  void correct(const Gaussian3& position, SphereObservation& observation, const RandomKey& key,
               ThreadTeam& team);
  /// Replaces all hypotheses by a hypothesis that another filter of this target has already
  /// predicted and updated. If `hypothesis` is null, no hypothesis is left.
  void setOnlyHypothesis(const TrackHypothesis* hypothesis);
  /// Removes the hypotheses at positions that another target occupies. Does nothing if the most
  /// likely hypothesis has a probability above one half.
  void removeOccupied(const std::vector<OccupiedSphere>& occupied);
  /// Keeps only the most likely of several hypotheses between which images cannot decide; see
  /// resolveAmbiguity(). The probability that this choice is wrong lowers the existence probability
  /// in estimate(). Set `identicalTargets` if other targets look the same: any of the positions is
  /// then correct, and the existence probability is not lowered.
  void resolveIdentity(bool identicalTargets);
  /// Multiplies the probability of the most likely hypothesis by 0.001, because another object was
  /// found at its position.
  void suppressBestHypothesis();

  const Target& target() const { return target_; }
  const std::optional<WorldBox>& bounds() const { return bounds_; }
  /// Returns the most likely hypothesis, or null if there is no hypothesis.
  const TrackHypothesis* mostLikelyHypothesis() const;
  /// Returns the most likely hypothesis if its probability is above one half, otherwise null.
  const TrackHypothesis* confidentHypothesis() const;
  /// Returns all hypotheses, the most likely first.
  const std::vector<TrackHypothesis>& hypotheses() const { return hypotheses_; }
  /// Returns the expected position of the target: the position of the most likely hypothesis,
  /// otherwise the last confirmed position. Returns nothing if no position was confirmed or if the
  /// last confirmed position is too old.
  std::optional<OccupiedSphere> expectedSphere() const;
  SphereEstimate estimate(SphereObservation& observation) const;
  /// Copies an even selection of at most `limit` particles; see ParticleCloud::copyParticles().
  void copyParticles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const;
  /// Returns the size of all particles in bytes.
  std::size_t memoryBytes() const;

private:
  void updateHypotheses(SphereObservation& observation, const RandomKey& key, ThreadTeam& team,
                        std::vector<double>& logMasses);
  /// Returns the prior probability of a hypothesis, before the images of this frame are used.
  /// Stores in the hypothesis whether the images show its rim (TrackHypothesis::wasRimSeen). A
  /// hypothesis that may be part of a larger object gets at most the probability of a birth.
  double priorProbability(TrackHypothesis& hypothesis, SphereObservation& observation) const;
  /// Returns the probability that an absent target appears at this position, or so close to it that
  /// images cannot distinguish the two positions.
  double birthProbability(const Eigen::Vector3d& position, double radius) const;
  /// Removes hypotheses that are more than their radius outside the bounds, and those with an
  /// impossible radius.
  void removeImpossible(std::vector<double>& logMasses);
  void addNewHypotheses(SphereObservation& observation, const CandidateSource& search,
                        const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                        ThreadTeam& team, std::vector<double>& logMasses);
  /// Adjusts the masses (probabilities before normalization) of the first hypotheses of a target.
  /// For these hypotheses, the log likelihood ratio is not limited by kSaturationShare, neighboring
  /// hypotheses do not count as contrary evidence, and the mismatch of the size is subtracted.
  void scoreInitialHypotheses(SphereObservation& observation, std::vector<double>& logMasses) const;
  /// Returns a hypothesis of unknown velocity, without particles.
  TrackHypothesis newHypothesis(const Gaussian3& position, double radius, double logRadiusVariance);
  TrackHypothesis createHypothesis(const OutlineFit& fit, SphereObservation& observation,
                                   const RandomKey& key, ThreadTeam& team);
  Eigen::Index particleCount(const TrackHypothesis& hypothesis) const;

  Target target_;
  BernoulliTrackSettings settings_;
  std::optional<WorldBox> bounds_;
  RadiusPrior radiusPrior_;
  SearchPrior searchPrior_;
  SearchParticles searchParticles_;
  /// Returns whether the most likely position has changed to one that cannot have been reached by
  /// the hypothesis that was confident before this frame.
  bool hasJumped() const;

  double identityAmbiguity_ = 0.0; ///< probability that resolveIdentity() chose wrongly
  /// Stream of the hypothesis that was confident before this frame; 0 if there was none.
  std::uint32_t confidentBefore_ = 0;
  bool createsHypotheses_ = true;
  std::vector<TrackHypothesis> hypotheses_; ///< after the last update
  std::vector<TrackHypothesis> predicted_;  ///< before the updates of this frame
  HypothesisNumbers numbers_{HypothesisNumbers::Half::Ball};
};

} // namespace dewpoint::tracking
