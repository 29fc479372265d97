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

/// Returns the header of a trajectory of this project: method, seed, parameters, version, cameras.
TrajectoryHeader trajectoryHeader(const Project& project);

/// Returns the header of a box track: method, seed, parameters, and a description of each target.
std::vector<std::pair<std::string, std::string>> boxTrackHeader(const Project& project);

/// Change of the settings of a run, from `before` to `after`.
struct DefinitionChange {
  RunDefinitionPtr before;
  RunDefinitionPtr after;
};

/// Change to a run in progress.
using RunChange = std::variant<DefinitionChange, PeopleChange, PositionCorrection>;

/// Run of a tracking method: tracks all targets, frame set by frame set. Both the window's tracking
/// thread and the command line use this class. Not thread-safe.
class TrackingRun {
public:
  /// Creates a run with `threadCount` threads. The tracking result does not depend on the number of
  /// threads. Returns NotFound for an unknown method.
  static Result<TrackingRun> create(RunDefinitionPtr definition, int threadCount);
  /// Creates the run of a project. `backgroundImages` has one image per camera, as returned by
  /// loadBackgroundImages(), or is empty. Returns NotFound for an unknown method.
  static Result<TrackingRun> create(const Project& project, int threadCount,
                                    std::vector<cv::Mat> backgroundImages = {});
  /// Creates a run with a given tracker, which need not be one of the program's own tracking
  /// methods.
  static TrackingRun fromTracker(std::unique_ptr<Tracker> tracker, RunDefinitionPtr definition,
                                 int threadCount);

  /// Returns the current definition (all settings of the run); never null.
  const RunDefinitionPtr& definition() const { return definition_; }
  /// Returns whether this run can continue with another definition (all settings of the run). The
  /// other definition must have the same method and image sizes, and the same number of targets
  /// unless the method can change this number. Otherwise, a new run is needed.
  bool accepts(const RunDefinition& definition) const;
  /// Discards all tracks and starts to track from scratch, with this random seed.
  void restart(std::uint64_t seed);
  /// Applies another definition (all settings of the run) from the next iteration on; tracks
  /// continue. The run must be able to continue with this definition: accepts() must return true. A
  /// new seed takes effect at the next restart().
  void apply(const RunDefinitionPtr& definition);
  void apply(const RunChange& change);

  /// Complete state of the run between two frames, from which the run can continue with
  /// bit-identical results.
  struct State {
    /// Copy of the tracker; null if the tracker cannot be copied.
    std::shared_ptr<const Tracker> tracker;
    RunDefinitionPtr definition;
    std::int64_t iterationCount = 0;
    std::size_t memoryBytes = 0;
  };
  /// Returns the current state, from which restore() continues. The state has no tracker if the
  /// method does not support copies of its tracker.
  State save() const;
  /// Restores a saved state, which must have a tracker.
  void restore(const State& state);
  /// Returns whether the method's tracker can be copied. Only then do states returned by save()
  /// contain a tracker.
  bool canBeCopied() const;
  /// Returns whether the method supports the corrections by the user that `Correcting` describes:
  /// corrected positions (PositionCorrecting), or people added and removed (PersonEditing).
  template <class Correcting> bool supportsCorrections() const {
    return capability<Correcting>() != nullptr;
  }
  /// Sets the number of iterations counted so far, so that a new run can continue the count of a
  /// previous one.
  void setIterationCount(std::int64_t iterationCount) { iterationCount_ = iterationCount; }
  /// Sets the number of threads from the next iteration on; it never changes the result.
  void setThreadCount(int threadCount) { team_ = std::make_unique<ThreadTeam>(threadCount); }
  int threadCount() const { return team_->threadCount(); }

  /// Begins a new frame with these images. The next calls of iterateTimed() run filter iterations
  /// on them.
  void beginFrame(FrameSetPtr frames);
  int iterationsPerFrame() const;
  /// Runs one filter iteration for every target and returns its duration in microseconds, averaged
  /// over the targets. After the last iteration of a frame, the corrections of this frame are
  /// applied.
  double iterateTimed();

  /// Returns what a correction of people changes in the current frame: a person to add or to
  /// remove. Empty if the method does not find people.
  PeopleChange effectOf(const PersonCorrection& correction);
  /// Returns an error for each correction of people that could not be applied since the last call
  /// of this function.
  std::vector<Error> takeCorrectionErrors() { return std::exchange(correctionErrors_, {}); }

  std::int64_t iterationCount() const { return iterationCount_; }
  /// Returns the tracked targets: the targets of the project or, for methods that find people, the
  /// persons found so far.
  const std::vector<Target>& targets() const;
  /// Returns the method's implementation of an optional interface, such as ClockEstimating; null if
  /// the method does not implement it.
  template <class Capability> const Capability* capability() const {
    return tracking::capability<Capability>(std::as_const(*tracker_));
  }
  const CameraRig& rig() const { return *definition_->rig; }
  TrackEstimate estimate(std::size_t track) const { return tracker_->estimate(track); }
  std::vector<TrackEstimate> estimates() const { return estimatesOf(*tracker_); }
  /// Returns the estimated clock errors of the cameras; empty if the method estimates none.
  std::vector<ClockEstimate> clockEstimates() const {
    const auto* const clocks = capability<ClockEstimating>();
    return clocks != nullptr ? clocks->clockEstimates() : std::vector<ClockEstimate>();
  }
  const FrameSetPtr& frames() const { return frames_; }
  /// Returns the estimates in the current frame as trajectory samples. Methods that find people
  /// give samples only for people present.
  std::vector<TrajectorySample> samples() const;
  /// Returns the bounding boxes of the current frame, for methods that track boxes; empty for
  /// others.
  std::vector<BoxSample> boxSamples() const;
  /// Copies up to `limit` particles of a target: their positions, as rows of x, y, z in meters, and
  /// their linear weights.
  void copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                     Eigen::ArrayXd& weights) const;
  /// Returns a record of the current estimates, without 3D particles but with up to
  /// `boxParticleLimit` particles per box. Status and camera reports are copied from `recorded`,
  /// the record already stored for this frame; `recorded` is null if there is none.
  TrackedFrame currentFrame(const TrackedFrame* recorded, int boxParticleLimit) const;
  /// Returns a record of the current frame, with up to `particleLimit` particles per target.
  /// `previous` is the record of the previous frame, null for the first frame; it tells when each
  /// target was last held (confirmed by the cameras).
  TrackedFrame trackedFrame(int particleLimit, const TrackedFrame* previous) const;
  /// Returns how many filter iterations have run on the current frame.
  int frameIterationCount() const { return frameIterationCount_; }
  /// Returns the number of targets being tracked or, for methods that find people, of people
  /// present.
  std::size_t trackedTargetCount() const;

private:
  /// Returns what currentFrame() and trackedFrame() have in common.
  TrackedFrame commonTrackedFrame(const TrackedFrame* before, int boxParticleLimit) const;
  void applyCorrection(const PeopleChange& people);
  void correctPeople();
  /// Corrects a position if the method supports this and has the target.
  void correct(const PositionCorrection& correction);
  void correctPositions();
  /// Returns whether the position of a target was corrected in the current frame.
  bool isCorrected(std::size_t target) const;

  RunDefinitionPtr definition_;
  std::unique_ptr<Tracker> tracker_;
  FrameSetPtr frames_;
  std::unique_ptr<ThreadTeam> team_;
  std::int64_t iterationCount_ = 0;
  int frameIterationCount_ = 0;
  std::vector<Error> correctionErrors_;
};

/// Table of the true positions of targets, for fast access by target and frame during tracking.
class TruthTable {
public:
  explicit TruthTable(const Trajectory& truth);
  /// Returns the true position of a target in a frame, in meters, world frame; nothing if unknown.
  std::optional<Eigen::Vector3d> at(const std::string& target, std::int64_t frame) const;

private:
  std::map<std::pair<std::string, std::int64_t>, Eigen::Vector3d> positions_;
};

} // namespace dewpoint::session
