// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/event_metrics.h"
#include "core/experiment/suite/suite_row.h"
#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Result of a run: its metrics and the data for the plots.
struct SuiteResult {
  SuiteRow row;
  SuiteTrace trace;
};

/// Collects the estimates of one method over the frames of one run and compares them with the
/// truth.
///
/// A target is declared present if its estimate is valid or its existence probability is above one
/// half. If several targets have the same color, a method may report them in any order. Estimates
/// are assigned to such targets once for the whole run, so that the targets are followed in as many
/// frames as possible. An estimate that later changes to another target counts as an error there.
class SuiteRecorder {
public:
  /// Creates a recorder for a run, which must outlive it.
  SuiteRecorder(const ScenarioRun& run, std::string method);

  /// Adds the estimates for the next frame. Frames start at 0.
  void add(const std::vector<SphereEstimate>& estimates);
  /// Returns the result for the frames added so far. `usPerFrame` is the measured time per frame in
  /// microseconds.
  SuiteResult result(double usPerFrame) const;

private:
  struct Samples;
  /// Adds the metrics of one target, to which the method's estimate with index `estimate` is
  /// assigned.
  void addTarget(std::size_t target, std::size_t estimate, Samples& samples,
                 SuiteResult& result) const;
  /// Returns the target size in a frame, or null if the run does not contain it.
  const TargetExtent* extentOf(std::size_t frame, std::size_t target) const;
  std::vector<std::size_t> truthToEstimate() const;
  std::vector<TargetFrame> framesOf(std::size_t truth, std::size_t estimate) const;
  std::vector<TrackFrame> trackFrames() const;
  bool areAllCamerasBlind(std::int64_t frame) const;
  bool isAnyCameraBlind(std::int64_t frame) const;

  const ScenarioRun& run_;
  std::string method_;
  /// truth_[frame][target]: target position. Empty while the target is absent.
  std::vector<std::vector<std::optional<Eigen::Vector3d>>> truth_;
  /// extents_[frame][target]; empty if the run does not contain sizes.
  std::vector<std::vector<TargetExtent>> extents_;
  std::vector<std::vector<SphereEstimate>> estimates_; ///< [frame][target]
};

} // namespace dewpoint::experiment
