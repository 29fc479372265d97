// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/search_particles.h"
#include "core/tracking/dewpoint/search/search_prior.h"
#include "core/tracking/dewpoint/track/hypothesis_estimate.h"
#include "core/tracking/dewpoint/track/hypothesis_masses.h"
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

/// The parameters of dewpointParameters() that a track depends on.
struct BernoulliTrackSettings {
  Eigen::Index maxParticles = 500;
  Eigen::Index minParticles = 100;
  double kldError = 0.1;          ///< Kullback-Leibler distance; 0: always maxParticles
  double accelerationSigma = 0.0; ///< m/s²; to be set: its default is with the parameters
  double survivalTime = 5.0;      ///< seconds
  double searchSize = 4.0;        ///< meters
  SystematicErrors errors;        ///< that estimates state
};

/// Finds candidate positions of the target in the images of an observation: as
/// CandidateSearch::find().
using CandidateSource = std::function<std::vector<Candidate>(SphereObservation& observation,
                                                             bool radiusKnown, std::size_t limit)>;

/// The track of one target: the probability that the target exists, and where it may be. A
/// Bernoulli filter (Ristic, Vo, Vo and Farina 2013) whose spatial density is a mixture of
/// hypotheses. In each frame they survive, are updated by the images, and compete with each other,
/// with new hypotheses from the images, and with "not there". New hypotheses take their probability
/// only from that of the target being absent, so that a distractor does not capture a target that
/// is clearly visible. World frame, meters.
class BernoulliTrack {
public:
  explicit BernoulliTrack(const Target& target);

  void configure(const BernoulliTrackSettings& settings) { settings_ = settings; }
  /// Whether hypotheses are created from the images; at first they are. Else a track has ended when
  /// its hypotheses have.
  void setCreatesHypotheses(bool creates) { createsHypotheses_ = creates; }
  void setTarget(const Target& target);
  /// Where the target may be from the next update on; nothing: anywhere. The start volume and the
  /// search particles lie in it from the next restart on.
  void setBounds(const std::optional<WorldBox>& bounds) { bounds_ = bounds; }
  /// Removes all hypotheses; the target is expected in the start volume, then elsewhere.
  void restart(const StartVolume& start, std::uint64_t seed);

  /// Predicts all hypotheses over `interval` seconds. Once per frame.
  void predict(double interval, const RandomKey& key);
  /// Updates the track by the images of the frame. A second update on the same frame starts from
  /// the prediction again, so that no measurement counts twice.
  void update(SphereObservation& observation, const CandidateSource& search,
              const std::vector<OccupiedSphere>& occupied, const RandomKey& key, ThreadTeam& team);
  /// Replaces all hypotheses by one at this position, with probability 0.98.
  void initializeAt(const Eigen::Vector3d& position, double radius, SphereObservation& observation,
                    const RandomKey& key, ThreadTeam& team);
  /// The target is at this position (m, m²): replaces all hypotheses by one, with probability 0.98
  /// and the radius believed until now, and updates it by the images of the frame.
  void correct(const Gaussian3& position, SphereObservation& observation, const RandomKey& key,
               ThreadTeam& team);
  /// Takes the hypothesis of another filter of this target for its only one, or none where it is
  /// null; predicted and updated by that filter.
  void adopt(const TrackHypothesis* hypothesis);
  /// Removes the hypotheses at occupied positions, unless the likeliest one has a probability above
  /// one half.
  void removeOccupied(const std::vector<OccupiedSphere>& occupied);
  /// Keeps the likeliest of several hypotheses that have all been fully visible for some frames: no
  /// image will ever tell which one is the target. The probability that this was wrong lowers the
  /// existence in estimate(), unless the target has `identicalTargets`: other targets that look the
  /// same, so that any of the positions is right.
  void resolveIdentity(bool identicalTargets);
  /// Multiplies the probability of the likeliest hypothesis by 0.001: another object was found to
  /// be there.
  void suppressBest();

  const Target& target() const { return target_; }
  const std::optional<WorldBox>& bounds() const { return bounds_; }
  /// The likeliest hypothesis; null when there is none.
  const TrackHypothesis* best() const;
  /// The likeliest hypothesis if its probability is above one half, else null.
  const TrackHypothesis* confident() const;
  /// All hypotheses, the likeliest first.
  const std::vector<TrackHypothesis>& hypotheses() const { return hypotheses_; }
  /// Where the target is expected: the likeliest hypothesis, or the last confirmed position;
  /// nothing when there was none, or too long ago.
  std::optional<OccupiedSphere> expectedSphere() const;
  SphereEstimate estimate(SphereObservation& observation) const;
  /// As ParticleCloud::particles().
  void particles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const;
  /// Bytes of its particles.
  std::size_t memoryBytes() const;

private:
  void updateHypotheses(SphereObservation& observation, const RandomKey& key, ThreadTeam& team,
                        std::vector<double>& logMasses);
  /// The probability of a hypothesis before the images of this frame count, and keeps in it whether
  /// they show its rim. Of what may be a part of something larger no more than at a birth.
  double probabilityBefore(TrackHypothesis& hypothesis, SphereObservation& observation) const;
  /// Probability that an absent target appears at a position, as far as images tell it from others.
  double birthProbability(const Eigen::Vector3d& position, double radius) const;
  /// Removes hypotheses that are more than their radius outside the bounds, and those of a radius
  /// that the target cannot have.
  void removeImpossible(std::vector<double>& logMasses);
  void addNewHypotheses(SphereObservation& observation, const CandidateSource& search,
                        const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                        ThreadTeam& team, std::vector<double>& logMasses);
  /// Changes the masses of the first hypotheses of a target: their evidence does not saturate, that
  /// of their neighbors does not count against them, and their size counts.
  void scoreInitialHypotheses(SphereObservation& observation, std::vector<double>& logMasses) const;
  /// A hypothesis of unknown velocity, without particles.
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
  /// Whether another position than the one that was confident before this frame is the likeliest
  /// now, without being where that can have moved.
  bool hasJumped() const;

  double identityAmbiguity_ = 0.0; ///< probability that resolveIdentity() chose wrongly
  /// The stream of the hypothesis that was confident before this frame; 0: none was.
  std::uint32_t confidentBefore_ = 0;
  bool createsHypotheses_ = true;
  std::vector<TrackHypothesis> hypotheses_; ///< after the last update
  std::vector<TrackHypothesis> predicted_;  ///< before the updates of this frame
  std::uint32_t nextStream_ = 1;            ///< of the next hypothesis
};

} // namespace dewpoint::tracking
