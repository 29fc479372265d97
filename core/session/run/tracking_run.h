// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project_rig.h"
#include "core/session/frames/tracked_frame.h"
#include "core/session/people/person_correction.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/run_definition.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"
#include "core/trajectory/trajectory.h"

#include <opencv2/core/mat.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dewpoint::session {

/// Header of a trajectory of this project: method, seed, parameters, version, cameras.
TrajectoryHeader trajectoryHeader(const Project& project);

/// Header of the boxes that were tracked: method, seed, parameters, and what each target is.
std::vector<std::pair<std::string, std::string>> boxTrackHeader(const Project& project);

/// A run uses `after` instead of `before`.
struct DefinitionChange {
  RunDefinitionPtr before;
  RunDefinitionPtr after;
};

/// A change for a run under way.
using RunChange = std::variant<DefinitionChange, PeopleChange, PositionCorrection>;

/// The tracker of all targets fed with frame sets: what the window's tracking thread and
/// the command line both drive. Not thread safe.
class TrackingRun {
public:
  /// `threadCount` threads share the work; they never change the result. NotFound for an unknown
  /// method.
  static Result<TrackingRun> create(RunDefinitionPtr definition, int threadCount);
  /// The run of a project; `emptyRooms` as of loadEmptyRooms(), or none.
  static Result<TrackingRun> create(const Project& project, int threadCount,
                                    std::vector<cv::Mat> emptyRooms = {});
  /// A run of a tracker that need not be a method of the catalog.
  static TrackingRun of(std::unique_ptr<Tracker> tracker, RunDefinitionPtr definition,
                        int threadCount);

  /// What the run goes by now; never null.
  const RunDefinitionPtr& definition() const { return definition_; }
  /// Whether a run of this definition is this one: of the same method, with the same images, and as
  /// many targets unless the method takes any number. If not, it needs a run of its own.
  bool takes(const RunDefinition& definition) const;
  /// Forgets all beliefs.
  void restart(std::uint64_t seed);
  /// Goes by another definition, which takes() it, from the next iteration on; what is believed
  /// stays. The tracker is told only of what is otherwise. Another seed counts from the next
  /// restart() on.
  void apply(const RunDefinitionPtr& definition);
  void apply(const RunChange& change);

  /// All that the run is between two frames, to go on from with the same bits.
  struct State {
    std::shared_ptr<const Tracker> tracker; ///< null when the method cannot be copied
    RunDefinitionPtr definition;
    std::int64_t iterations = 0;
    std::size_t bytes = 0;
  };
  State save() const;
  /// `state` has a tracker.
  void restore(const State& state);
  /// Whether save() has a tracker to restore.
  bool canBeCopied() const;
  /// Whether the user may correct positions.
  bool takesCorrections() const { return capability<PositionCorrecting>() != nullptr; }
  /// Goes on counting iterations from here.
  void countFrom(std::int64_t iterations) { iterations_ = iterations; }
  /// The number of threads that share the work from the next iteration on; it never changes the
  /// result.
  void setThreadCount(int threadCount) { team_ = std::make_unique<ThreadTeam>(threadCount); }
  int threadCount() const { return team_->threadCount(); }

  void beginFrame(FrameSetPtr frames);
  int iterationsPerFrame() const;
  /// One filter iteration for every target; microseconds it took, averaged over the targets. With
  /// the last one of a frame, the corrections of this frame come true.
  double iterate();

  /// What a correction means in the current frame; nothing unless the method finds people.
  PeopleChange changeBy(const PersonCorrection& correction);
  /// Corrections of people that could not be granted since the last call.
  std::vector<Error> takeRefusals() { return std::exchange(refusals_, {}); }

  std::int64_t iterations() const { return iterations_; }
  /// Those that are tracked: the project's, or the persons who have been there.
  const std::vector<Target>& targets() const;
  /// What the method can do besides tracking, see capability(); null when it cannot.
  template <class Capability> const Capability* capability() const {
    return tracking::capability<Capability>(std::as_const(*tracker_));
  }
  const CameraRig& rig() const { return *definition_->rig; }
  TrackEstimate estimate(std::size_t track) const { return tracker_->estimate(track); }
  std::vector<TrackEstimate> estimates() const { return estimatesOf(*tracker_); }
  const FrameSetPtr& frames() const { return frames_; }
  /// The estimates as trajectory samples of the current frame; of people, those who are there.
  std::vector<TrajectorySample> samples() const;
  /// The boxes of the current frame, of methods that follow boxes.
  std::vector<BoxSample> boxSamples() const;
  /// Up to `limit` particles of a target; rows x y z, meters, and their weights, linear.
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const;
  /// What is believed now, without particles in space; `recorded` is the TrackedFrame that was kept
  /// of this frame, null when it was not tracked: how the targets are doing, and why, is from
  /// there.
  TrackedFrame present(const TrackedFrame* recorded, int boxParticleLimit) const;
  /// What is kept of the current frame; `previous` is the one before it, null at the beginning.
  TrackedFrame trackedFrame(int particleLimit, const TrackedFrame* previous) const;
  /// Iterations on the current frame.
  int frameIterations() const { return frameIterations_; }
  /// Targets that are tracked now; of people, those who are there.
  std::size_t trackedCount() const;

private:
  /// The common part of both kinds of tracked frames.
  TrackedFrame commonTrackedFrame(const TrackedFrame* before, int boxParticleLimit) const;
  void applyCorrection(const PeopleChange& people);
  void correctPeople();
  /// Nothing unless the method can, and has this target.
  void correct(const PositionCorrection& correction);
  void correctPositions();
  /// Whether the position of a target was corrected in the current frame.
  bool isCorrected(std::size_t target) const;

  RunDefinitionPtr definition_;
  std::unique_ptr<Tracker> tracker_;
  FrameSetPtr frames_;
  std::unique_ptr<ThreadTeam> team_;
  std::int64_t iterations_ = 0;
  int frameIterations_ = 0;
  std::vector<Error> refusals_;
};

/// Truth by target and frame, found quickly while tracking.
class TruthTable {
public:
  explicit TruthTable(const Trajectory& truth);
  std::optional<Eigen::Vector3d> at(const std::string& target, std::int64_t frame) const;

private:
  std::map<std::pair<std::string, std::int64_t>, Eigen::Vector3d> positions_;
};

} // namespace dewpoint::session
