// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/snapshot.h"
#include "core/tracking/multi_tracker.h"
#include "core/trajectory/trajectory.h"

#include <map>
#include <memory>
#include <vector>

namespace dewpoint {

/// Cameras of a project, in its order.
CameraRig rigOf(const Project& project);

/// Header of a trajectory of this project: method, seed, parameters, version, cameras.
TrajectoryHeader trajectoryHeader(const Project& project);

/// The tracker of all targets fed with frame sets: what the window's tracking thread and
/// the command line both drive. Not thread safe.
class TrackingRun {
public:
  /// NotFound for an unknown method.
  static Result<TrackingRun> create(const Project& project, int threadCount);

  /// Forgets all beliefs.
  void restart(std::uint64_t seed);
  void configure(const ParameterValues& parameters);
  /// New colors for the same targets; a different number of targets is ignored (reopen instead).
  void setTargets(const std::vector<Target>& targets);

  void beginFrame(FrameSetPtr frames);
  int iterationsPerFrame() const;
  /// One filter iteration for every target; microseconds it took, averaged over the targets.
  double iterate();

  std::int64_t iterations() const { return iterations_; }
  const std::vector<Target>& targets() const { return targets_; }
  const std::vector<TargetEstimate>& estimates() const { return tracker_->estimates(); }
  const FrameSetPtr& frames() const { return frames_; }
  /// The estimates as trajectory samples of the current frame.
  std::vector<TrajectorySample> samples() const;
  /// What views show, without tail and truth.
  std::vector<TargetSnapshot> snapshots(int particleLimit) const;

private:
  std::vector<Target> targets_;
  std::unique_ptr<MultiTracker> tracker_;
  FrameSetPtr frames_;
  std::unique_ptr<ThreadTeam> team_;
  std::int64_t iterations_ = 0;
};

/// Truth by target and frame, for quick look-up while tracking.
class TruthTable {
public:
  explicit TruthTable(const Trajectory& truth);
  std::optional<Eigen::Vector3d> at(const std::string& target, std::int64_t frame) const;

private:
  std::map<std::pair<std::string, std::int64_t>, Eigen::Vector3d> positions_;
};

} // namespace dewpoint
