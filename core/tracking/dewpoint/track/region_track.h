// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/ellipsoid_fit.h"
#include "core/observation/region/region_observation.h"
#include "core/tracking/dewpoint/track/bernoulli_track.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The track of a target that is taken for no ball: one hypothesis about where it is, and an
/// ellipsoid that tells how far it extends, learned from the regions of its color. A Bernoulli
/// filter as BernoulliTrack; the extent is smoothed from frame to frame (as random matrices are:
/// Koch 2008). World frame, meters.
class RegionTrack {
public:
  explicit RegionTrack(const Target& target) : target_(target) {}

  void configure(const BernoulliTrackSettings& settings) { settings_ = settings; }
  void setTarget(const Target& target) { target_ = target; }
  void setBounds(const std::optional<WorldBox>& bounds) { bounds_ = bounds; }
  /// Forgets the target; it is expected in the start volume, then elsewhere.
  void restart(const StartVolume& start);
  /// Forgets the hypothesis.
  void forget();
  /// The target is at this position (m, m²) and about as large as the ellipsoid around it: replaces
  /// the hypothesis by one with probability 0.98, and updates it by the images of the frame.
  void startAt(const Gaussian3& position, const Eigen::Matrix3d& extent, bool byHand,
               RegionObservation& observation, const RandomKey& key, ThreadTeam& team);

  /// Predicts over `interval` seconds. Once per frame.
  void predict(double interval, const RandomKey& key);
  /// Updates the hypothesis by the images of the frame, or searches them for one. A second update
  /// on the same frame starts from the prediction again.
  void update(RegionObservation& observation, const std::vector<OccupiedSphere>& occupied,
              const RandomKey& key, ThreadTeam& team);

  /// The hypothesis, with the radius of a ball of its volume; null when there is none.
  const TrackHypothesis* hypothesis() const { return state_ ? &state_->hypothesis : nullptr; }
  /// Of the hypothesis, which there must be; m², as Ellipsoid has it.
  const Eigen::Matrix3d& extent() const { return state_->extent; }
  /// Its longest semi-axis, meters.
  double longestAxis() const;
  /// What each camera showed at the last update; empty when there is no hypothesis.
  std::vector<RegionMeasurement> views() const {
    return state_ ? state_->views : std::vector<RegionMeasurement>();
  }
  /// The hypothesis, which there must be, as an estimate.
  SphereEstimate estimate(const RegionObservation& observation) const;
  std::size_t memoryBytes() const;

private:
  struct State {
    TrackHypothesis hypothesis;
    Eigen::Matrix3d extent = Eigen::Matrix3d::Zero();
    double ambiguity = 0.0;    ///< probability that another object is meant
    double disagreement = 1.0; ///< running mean of EllipsoidFit's, per degree of freedom
    double fill = 0.0;         ///< share of its outlines that has the color; 0: not known
    std::vector<RegionMeasurement> views;
  };

  EllipsoidFit fitAt(const State& state, RegionObservation& observation) const;
  /// The log factor of the odds that the target is there.
  double measure(State& state, RegionObservation& observation) const;
  void accept(State& state, const EllipsoidFit& fit) const;
  void search(RegionObservation& observation, const std::vector<OccupiedSphere>& occupied);
  State newState(const Gaussian3& position, const Eigen::Matrix3d& extent);
  void draw(const RandomKey& key, ThreadTeam& team);

  Target target_;
  BernoulliTrackSettings settings_;
  std::optional<WorldBox> bounds_;
  SearchPrior searchPrior_;
  std::optional<State> state_;     ///< after the last update
  std::optional<State> predicted_; ///< before the updates of this frame
  std::uint32_t nextStream_ = 1;
};

} // namespace dewpoint::tracking
