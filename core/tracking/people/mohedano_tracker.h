// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_filter.h"
#include "core/observation/people/person_observation.h"
#include "core/tracking/people/people_track_lifecycle.h"

#include <vector>

namespace dewpoint::tracking {

/// The `mohedano-ms` and `mohedano-msc` methods (Mohedano, García, Salgado and Jaureguizar 2009).
/// Each person has an independent particle filter. The state consists of position and velocity (x y
/// z vx vy vz) and, with `mohedano-msc`, also hue and saturation (h s). PeopleTrackLifecycle
/// handles what the paper does not describe: the background, and the creation and removal of
/// tracks.
class MohedanoTracker final : public PeopleTrackLifecycle {
public:
  MohedanoTracker(const ParameterValues& parameters, const CameraRig& rig, bool color);

  void configure(const ParameterValues& parameters) override;
  BodyCloud bodyOf(int identity) const override;
  std::unique_ptr<Tracker> clone() const override;

private:
  struct Belief {
    int identity = 0;
    ParticleFilter filter;
  };

  void createBelief(const PersonEstimate& person, const RandomKey& key) override;
  void removeBelief(std::size_t index) override;
  void removeAllBeliefs() override { beliefs_.clear(); }
  std::size_t beliefMemoryBytes() const override;
  void updateBeliefs(ThreadTeam& team) override;
  bool ignoresForegroundOfKnownPeople() const override { return false; }
  MotionSmoothing motionSmoothing() const override {
    return {parameters_.at("mask_sigma"), parameters_.at("motion_floor")};
  }

  /// Returns hue and saturation at the projection of a position (meters, world frame) in the image
  /// of a camera that shows motion there. `pick`, from 0 to 1, selects one of these cameras.
  Eigen::Vector2d colorAt(const Eigen::Vector3d& position, double pick) const;
  PersonObservation observation() const;
  void describe(const StateEstimate& estimate, const Belief& belief, PersonEstimate& person) const;

  ParameterValues parameters_;
  bool color_;
  std::vector<Belief> beliefs_; ///< particle filters of the people, in the order of `people_`
  std::vector<cv::Mat> likelihoods_;
};

} // namespace dewpoint::tracking
