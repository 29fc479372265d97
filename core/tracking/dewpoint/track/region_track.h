// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/ellipsoid_fit.h"
#include "core/observation/region/region_observation.h"
#include "core/tracking/dewpoint/track/bernoulli_track.h"
#include "core/tracking/dewpoint/track/hypothesis_numbers.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Track of a target that is not assumed to be a ball. The track has one hypothesis about the
/// position, and an ellipsoid for the extent, learned from the regions of the target's color. The
/// track is a Bernoulli filter like BernoulliTrack. The extent is smoothed from frame to frame, as
/// in the random-matrix approach (Koch 2008). World frame, meters.
class RegionTrack {
public:
  explicit RegionTrack(const Target& target) : target_(target) {}

  void configure(const BernoulliTrackSettings& settings) { settings_ = settings; }
  void setTarget(const Target& target) { target_ = target; }
  void setBounds(const std::optional<WorldBox>& bounds) { bounds_ = bounds; }
  /// Discards the hypothesis and the last position. The target is then expected in the start volume
  /// first, and elsewhere later.
  void restart(const StartVolume& start);
  /// Discards the hypothesis.
  void discardHypothesis();
  /// Replaces the hypothesis by a new hypothesis at this position (m, m²), with probability 0.98
  /// and the approximate extent `extent` (m²). Updates the new hypothesis with the images of the
  /// frame. `byHand` is true if the user gave the position.
  void startAt(const Gaussian3& position, const Eigen::Matrix3d& extent, bool byHand,
               RegionObservation& observation, const RandomKey& key, ThreadTeam& team);

  /// Predicts the hypothesis over `interval` seconds. Call this function once per frame.
  void predict(double interval, const RandomKey& key);
  /// Updates the hypothesis with the images of the frame. Without a hypothesis, searches the images
  /// for a new hypothesis. A second update in the same frame starts from the prediction again.
  void update(RegionObservation& observation, const std::vector<OccupiedSphere>& occupied,
              const RandomKey& key, ThreadTeam& team);

  /// Returns the hypothesis, with the radius of a ball of equal volume, or null if there is no
  /// hypothesis.
  const TrackHypothesis* hypothesis() const { return state_ ? &state_->hypothesis : nullptr; }
  /// Returns the extent (m², as in Ellipsoid) of the hypothesis. The hypothesis must exist.
  const Eigen::Matrix3d& extent() const { return state_->extent; }
  /// Returns the longest semi-axis of the extent in meters.
  double longestAxis() const;
  /// Returns the measurement of each camera at the last update, or an empty list if there is no
  /// hypothesis.
  std::vector<RegionMeasurement> measurements() const {
    return state_ ? state_->measurements : std::vector<RegionMeasurement>();
  }
  /// Returns the estimate of the target from the hypothesis. The hypothesis must exist.
  SphereEstimate estimate(const RegionObservation& observation) const;
  std::size_t memoryBytes() const;

private:
  struct State {
    TrackHypothesis hypothesis;
    Eigen::Matrix3d extent = Eigen::Matrix3d::Zero();
    double ambiguity = 0.0; ///< probability that the hypothesis is another object
    /// Running mean of EllipsoidFit::disagreement per degree of freedom.
    double meanCameraDisagreement = 1.0;
    double coloredFraction =
        0.0; ///< fraction of its outlines that has the target's color; 0: unknown
    std::vector<RegionMeasurement> measurements;
  };

  EllipsoidFit fitAt(const State& state, RegionObservation& observation) const;
  /// Measures the target in the images and updates `state`. Returns the logarithm of the factor by
  /// which the images change the odds that the target is at the position of `state`.
  double measure(State& state, RegionObservation& observation) const;
  void accept(State& state, const EllipsoidFit& fit) const;
  void search(RegionObservation& observation, const std::vector<OccupiedSphere>& occupied);
  State newState(const Gaussian3& position, const Eigen::Matrix3d& extent);
  void draw(const RandomKey& key, ThreadTeam& team);

  Target target_;
  BernoulliTrackSettings settings_;
  std::optional<WorldBox> bounds_;
  SearchPrior searchPrior_;
  /// State of the hypothesis after the last update; empty: no hypothesis.
  std::optional<State> state_;
  std::optional<State> predicted_; ///< state of the hypothesis before the updates of this frame
  HypothesisNumbers numbers_{HypothesisNumbers::Half::Region};
};

} // namespace dewpoint::tracking
