// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project_rig.h"
#include "core/session/frames/tracked_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/snapshot.h"
#include "core/tracking/multi_tracker.h"
#include "core/trajectory/trajectory.h"

#include <opencv2/core/mat.hpp>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Header of a trajectory of this project: method, seed, parameters, version, cameras.
TrajectoryHeader trajectoryHeader(const Project& project);

/// Header of the boxes that were tracked: method, seed, parameters, and what each target is.
std::vector<std::pair<std::string, std::string>> boxTrackHeader(const Project& project);

/// A change of a run under way: other parameters, other colors, another calibration,
/// or another empty room.
struct RunChange {
  std::optional<ParameterValues> parameters;
  std::optional<std::vector<Target>> targets;
  std::optional<CameraRig> rig;
  std::optional<std::vector<cv::Mat>> emptyRooms = std::nullopt;
  std::optional<Eigen::Vector3d> newPerson = std::nullopt; ///< PeopleTracker::addPerson
  std::optional<int> personGone = std::nullopt;            ///< PeopleTracker::removePerson
};

/// The tracker of all targets fed with frame sets: what the window's tracking thread and
/// the command line both drive. Not thread safe.
class TrackingRun {
public:
  /// `emptyRooms` as of loadEmptyRooms(), or none. NotFound for an unknown method.
  static Result<TrackingRun> create(const Project& project, int threadCount,
                                    const std::vector<cv::Mat>& emptyRooms = {});

  /// Forgets all beliefs.
  void restart(std::uint64_t seed);
  void configure(const ParameterValues& parameters);
  /// New colors for the same targets; a different number of targets is ignored (reopen instead),
  /// but by methods of family Boxes and People: to people the project's targets mean nothing.
  void setTargets(const std::vector<Target>& targets);

  /// Another calibration of the same cameras; one for other images is ignored (reopen instead).
  void setCameras(const CameraRig& rig);
  /// As of loadEmptyRooms(); what is believed stays.
  void setEmptyRooms(const std::vector<cv::Mat>& rooms);

  void apply(const RunChange& change);

  /// All that the run is between two frames, to go on from with the same bits.
  struct State {
    std::shared_ptr<const MultiTracker> tracker; ///< null when the method cannot be copied
    std::vector<Target> targets;
    ParameterValues parameters;
    std::int64_t iterations = 0;
    std::size_t bytes = 0;
    CameraRig rig;
  };
  State save() const;
  /// What the run is told, without what it believes: a state without a tracker.
  State definition() const { return {nullptr, targets_, parameters_, iterations_, 0, rig_}; }
  void restore(const State& state);
  /// Whether save() has a tracker to restore.
  bool canBeCopied() const { return tracker_->canBeCopied(); }
  /// Goes on counting iterations from here.
  void countFrom(std::int64_t iterations) { iterations_ = iterations; }

  void beginFrame(FrameSetPtr frames);
  int iterationsPerFrame() const;
  /// One filter iteration for every target; microseconds it took, averaged over the targets.
  double iterate();

  MethodFamily family() const { return family_; }
  std::int64_t iterations() const { return iterations_; }
  /// Those that are tracked: the project's, or the persons who have been there.
  const std::vector<Target>& targets() const;
  const std::vector<Target>& projectTargets() const { return targets_; }
  /// Null unless the method is for people.
  const PeopleTargets* people() const;
  const CameraRig& rig() const { return rig_; }
  const ParameterValues& parameters() const { return parameters_; }
  const std::vector<TargetEstimate>& estimates() const { return tracker_->estimates(); }
  const FrameSetPtr& frames() const { return frames_; }
  /// The estimates as trajectory samples of the current frame; of people, those who are there.
  std::vector<TrajectorySample> samples() const;
  /// The boxes of the current frame, with methods of family Boxes.
  std::vector<BoxSample> boxSamples() const;
  /// What is believed of a target's box; nothing before there is one.
  std::optional<BoxBelief> box(std::size_t target, int particleLimit) const {
    return tracker_->box(target, particleLimit);
  }
  /// What views show, without tail and truth.
  std::vector<TargetSnapshot> snapshots(int particleLimit) const;
  /// What is kept of the current frame; `previous` is the moment before it, null at the beginning.
  TrackedFrame moment(int particleLimit, const TrackedFrame* previous) const;
  /// Around the estimate of a target, one per camera; may be empty.
  std::vector<LikelihoodMap> likelihoodMaps(std::size_t target, int reach) const {
    return tracker_->likelihoodMaps(target, reach);
  }
  /// Iterations on the current frame.
  int frameIterations() const { return frameIterations_; }
  /// Targets that are tracked now; of people, those who are there.
  std::size_t trackedCount() const;

private:
  std::optional<PersonEstimate> personAt(std::size_t target) const;

  MethodFamily family_ = MethodFamily::Targets;
  std::vector<Target> targets_; ///< the project's
  std::unique_ptr<MultiTracker> tracker_;
  FrameSetPtr frames_;
  std::unique_ptr<ThreadTeam> team_;
  ParameterValues parameters_;
  CameraRig rig_;
  std::int64_t iterations_ = 0;
  int frameIterations_ = 0;
};

/// Truth by target and frame, for quick look-up while tracking.
class TruthTable {
public:
  explicit TruthTable(const Trajectory& truth);
  std::optional<Eigen::Vector3d> at(const std::string& target, std::int64_t frame) const;

private:
  std::map<std::pair<std::string, std::int64_t>, Eigen::Vector3d> positions_;
};

} // namespace dewpoint::session
