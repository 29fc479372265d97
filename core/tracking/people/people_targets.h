// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/multi_tracker.h"
#include "core/tracking/people/people_tracker.h"

#include <Eigen/Core>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// A method for people as a MultiTracker, so that a run treats it as all others. Its targets are
/// the persons: the one of identity N is target N - 1, from birth on and after it has left (then
/// `gone`, without particles); so their number grows. One iteration per frame is all there is;
/// further ones change nothing. The particles of a person are the points of the body.
class PeopleTargets final : public MultiTracker {
public:
  explicit PeopleTargets(std::unique_ptr<PeopleTracker> tracker);

  void configure(const ParameterValues& parameters) override;
  /// The project's targets mean nothing to people.
  void setTargets(const std::vector<Target>& /*targets*/) override {}
  bool takesAnyNumber() const override { return true; }
  void setCameras(const CameraRig& rig) override { tracker_->setCameras(rig); }
  void setEmptyRooms(const std::vector<cv::Mat>& rooms) override { tracker_->setEmptyRooms(rooms); }
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  const std::vector<TargetEstimate>& estimates() const override { return estimates_; }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;
  std::unique_ptr<MultiTracker> clone() const override;
  bool canBeCopied() const override { return tracker_->canBeCopied(); }
  std::size_t memoryBytes() const override;
  PeopleTargets* people() override { return this; }
  const PeopleTargets* people() const override { return this; }

  /// Everybody who has been there: "person 1", "person 2", ...
  const std::vector<Target>& targets() const { return targets_; }
  /// Null when nobody with this index is there now.
  const PersonEstimate* person(std::size_t target) const;
  const PeopleTracker& tracker() const { return *tracker_; }
  /// As PeopleTracker::addPerson and removePerson.
  int addPerson(const Eigen::Vector3d& middle);
  void removePerson(int identity);

private:
  /// Takes over what the tracker believes.
  void describe();

  std::unique_ptr<PeopleTracker> tracker_;
  FrameSetPtr frames_;
  bool stepped_ = false; ///< on this frame
  std::vector<Target> targets_;
  std::vector<TargetEstimate> estimates_;
  mutable std::map<int, BodyCloud> bodies_; ///< of this frame, those that were asked for
};

} // namespace dewpoint::tracking
