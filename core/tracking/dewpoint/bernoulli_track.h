// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/candidate_search.h"
#include "core/tracking/dewpoint/hypothesis_masses.h"
#include "core/tracking/dewpoint/track_hypothesis.h"
#include "core/tracking/start_parameters.h"
#include "core/tracking/target.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// How a belief behaves.
struct BernoulliTrackSettings {
  Eigen::Index maxParticles = 500;
  Eigen::Index minParticles = 100;
  double kldError = 0.1;          ///< 0: always the most
  double accelerationSigma = 8.0; ///< m/s²
  double survivalTime = 5.0;      ///< seconds
  double searchSize = 4.0;        ///< metres
};

/// Finds places where the target may be in the images of an observation: as
/// CandidateSearch::find().
using CandidateSource = std::function<std::vector<Candidate>(SphereObservation& observation,
                                                             bool radiusKnown, std::size_t limit)>;

/// What is believed about one target: whether it is there at all, and where it may be. A Bernoulli
/// filter (Ristic, Vo, Vo and Farina 2013) over the hypotheses: each frame they survive, are looked
/// at, and compete with each other, with new ones proposed from the images and with "not there".
/// New ones come only from the probability that the target is not where it was, so that a target
/// that is well seen is not captured by a look-alike.
class BernoulliTrack {
public:
  explicit BernoulliTrack(const Target& target);

  void configure(const BernoulliTrackSettings& settings) { settings_ = settings; }
  /// A belief that does not search is gone when its hypotheses are.
  void setSearching(bool searching) { searching_ = searching; }
  void setTarget(const Target& target);
  /// Forgets everything; the target is first looked for in this volume, then elsewhere.
  void restart(const StartVolume& start, std::uint64_t seed);

  /// Moves everything on by `interval` seconds.
  void predict(double interval, const RandomKey& key);
  /// One iteration on the images of the frame; a further one on the same frame does not count the
  /// same evidence twice.
  void update(SphereObservation& observation, const CandidateSource& search,
              const std::vector<OccupiedSphere>& occupied, const RandomKey& key, ThreadTeam& team);
  /// Believes in this place from now on.
  void initializeAt(const Eigen::Vector3d& position, double radius, SphereObservation& observation,
                    const RandomKey& key, ThreadTeam& team);
  /// Gives up every place that others occupy, unless it is likelier than not.
  void removeOccupied(const std::vector<OccupiedSphere>& occupied);
  /// Settles for the likeliest of several places that are all well seen for some frames: the images
  /// will never tell which it is. The doubt stays, in the probability that estimate() gives, unless
  /// the target has `identicalTargets`: other targets that look the same, so that any of the places
  /// is right.
  void resolveIdentity(bool identicalTargets);
  /// Makes the likeliest place far less likely: another target was found to be there.
  void suppressBest();

  const Target& target() const { return target_; }
  /// The likeliest hypothesis; null when there is none.
  const TrackHypothesis* best() const;
  /// All hypotheses, the likeliest first.
  const std::vector<TrackHypothesis>& hypotheses() const { return hypotheses_; }
  /// Where the target is expected: its likeliest place, or where it was seen last; nothing when it
  /// was not seen yet, or too long ago.
  std::optional<OccupiedSphere> expected() const;
  std::size_t memoryBytes() const;
  /// The best hypothesis if it is likelier than not.
  const TrackHypothesis* confident() const;
  SphereEstimate estimate(SphereObservation& observation) const;
  void particles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const;

private:
  /// Particles that look for the target where nothing is known about it.
  struct SearchParticles {
    Eigen::ArrayXXd states;
    Eigen::ArrayXd weights;
  };

  void drawSearchCloud(const RandomKey& key);
  void stepSearchCloud(SphereObservation& observation, const RandomKey& key, ThreadTeam& team);
  void updateHypotheses(SphereObservation& observation, const RandomKey& key, ThreadTeam& team,
                        std::vector<double>& logMasses);
  void addBirths(SphereObservation& observation, const CandidateSource& search,
                 const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                 ThreadTeam& team, std::vector<double>& logMasses);
  /// Of the first hypotheses all evidence counts, without that of their neighbors, and their size.
  void scoreInitialHypotheses(SphereObservation& observation, std::vector<double>& logMasses) const;
  TrackHypothesis createHypothesis(const OutlineFit& fit, SphereObservation& observation,
                                   const RandomKey& key, ThreadTeam& team);
  double birthDensity(const Eigen::Vector3d& place) const;
  Eigen::Index particleCount(const TrackHypothesis& hypothesis) const;

  Target target_;
  BernoulliTrackSettings settings_;
  StartVolume start_;
  Gaussian3 searchPrior_;          ///< where it is looked for first
  double identityAmbiguity_ = 0.0; ///< probability that decide() chose wrongly
  bool everSeen_ = false;
  bool searching_ = true;
  std::vector<TrackHypothesis> hypotheses_; ///< after the last update
  std::vector<TrackHypothesis> predicted_;  ///< before the updates of this frame
  SearchParticles cloud_;
  std::uint32_t nextStream_ = 1;
  std::uint64_t seed_ = 0;
};

} // namespace dewpoint::tracking
