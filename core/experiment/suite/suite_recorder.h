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
/// half. If several targets have the same color, a method may name them in any order. Over the
/// whole run, estimates are assigned to targets of their color so that most frames are followed.
/// Later confusions count as errors.
class SuiteRecorder {
public:
  /// `run` must outlive the recorder.
  SuiteRecorder(const ScenarioRun& run, std::string method);

  /// Adds the next frame, from 0 on.
  void add(const std::vector<SphereEstimate>& estimates);
  /// Result of the frames added so far. `usPerFrame` is the measured time in microseconds.
  SuiteResult result(double usPerFrame) const;

private:
  struct Samples;
  /// Adds the measurements of one target, which the method's estimate `estimate` follows.
  void addTarget(std::size_t target, std::size_t estimate, Samples& samples,
                 SuiteResult& result) const;
  /// Size of the target at a frame; null if the run does not contain it.
  const TargetExtent* extentOf(std::size_t frame, std::size_t target) const;
  std::vector<std::size_t> estimateOfTruth() const;
  std::vector<TargetFrame> framesOf(std::size_t truth, std::size_t estimate) const;
  std::vector<TrackFrame> trackFrames() const;
  bool allBlind(std::int64_t frame) const;
  bool anyBlind(std::int64_t frame) const;

  const ScenarioRun& run_;
  std::string method_;
  /// truth_[frame][target]: its position; nothing while it is absent.
  std::vector<std::vector<std::optional<Eigen::Vector3d>>> truth_;
  /// extents_[frame][target]; empty if the run does not contain sizes.
  std::vector<std::vector<TargetExtent>> extents_;
  std::vector<std::vector<SphereEstimate>> estimates_; ///< [frame][target]
};

} // namespace dewpoint::experiment
