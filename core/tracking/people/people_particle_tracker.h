// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_filter.h"
#include "core/observation/people/clothes_model.h"
#include "core/tracking/people/people_track_lifecycle.h"

#include <map>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// The `people` method, developed for this project. Each person has a particle filter. The state
/// consists of position and velocity on the floor, and height. The weights measure how well a
/// standing body fits the motion masks of all cameras. Pixels covered by other people are assigned
/// to these people, two people cannot stand at one position, and clothes distinguish people who
/// have met.
class PeopleParticleTracker final : public PeopleTrackLifecycle {
public:
  PeopleParticleTracker(const ParameterValues& parameters, const CameraRig& rig);

  void configure(const ParameterValues& parameters) override;
  BodyCloud bodyOf(int identity) const override;
  std::unique_ptr<Tracker> clone() const override;

private:
  struct Belief {
    int identity = 0;
    ParticleFilter filter;
    ClothesModel clothes;
  };
  /// Data about two people who are or were near each other. `identityEvidence` comes from their
  /// clothes, and is negative if their identities seem to be exchanged. `secondsSinceNear` is the
  /// time in seconds since the two were near each other.
  struct Meeting {
    double identityEvidence = 0.0;
    double secondsSinceNear = 0.0;
  };

  void createBelief(const PersonEstimate& person, const RandomKey& key) override;
  void removeBelief(std::size_t index) override;
  void removeAllBeliefs() override;
  std::size_t beliefMemoryBytes() const override;
  void updateBeliefs(ThreadTeam& team) override;
  bool ignoresForegroundOfKnownPeople() const override { return true; }
  MotionSmoothing motionSmoothing() const override;

  std::vector<ScoreSums> scoresFor(std::size_t person) const;
  cv::Mat coveredByOthers(std::size_t person, std::size_t camera) const;
  void weigh(std::size_t person, ThreadTeam& team);
  void learnClothes();
  void updateMeetings();
  double clothesEvidence(std::size_t one, std::size_t other) const;
  void swapIdentities(std::size_t one, std::size_t other);
  bool areNear(std::size_t one, std::size_t other) const;

  ParameterValues parameters_;
  std::vector<Belief> beliefs_; ///< particle filters of the people, in the order of `people_`
  std::map<std::pair<int, int>, Meeting> meetings_;
};

} // namespace dewpoint::tracking
