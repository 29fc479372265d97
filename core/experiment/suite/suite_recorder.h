// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/event_metrics.h"
#include "core/experiment/suite/suite_row.h"
#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// What a run gives: its figures and what the plots need of it.
struct SuiteResult {
  SuiteRow row;
  SuiteTrace trace;
};

/// Collects the estimates of one method over the frames of one run and measures it against the
/// truth.
///
/// A target is declared present when its estimate is valid or existence is above one half. With
/// several targets of one color a method may name them as it likes: over the whole run, estimates
/// are given to targets of their color so that most frames are followed; what it mixes up later,
/// counts as an error.
class SuiteRecorder {
public:
  /// `run` outlives this.
  SuiteRecorder(const ScenarioRun& run, std::string method);

  /// The next frame, from 0 on.
  void add(const std::vector<SphereEstimate>& estimates);
  SuiteResult result(double usPerFrame) const;

private:
  struct Samples;
  /// Adds what is measured of one target, which is followed by the method's estimate `estimate`.
  void addTarget(std::size_t target, std::size_t estimate, Samples& samples,
                 SuiteResult& result) const;
  /// How large the target is at a frame; nothing where the run does not tell.
  const TargetExtent* extentOf(std::size_t frame, std::size_t target) const;
  std::vector<std::size_t> estimateOfTruth() const;
  std::vector<TargetFrame> framesOf(std::size_t truth, std::size_t estimate) const;
  std::vector<TrackFrame> trackFrames() const;
  bool allBlind(std::int64_t frame) const;
  bool anyBlind(std::int64_t frame) const;

  const ScenarioRun& run_;
  std::string method_;
  /// truth_[frame][target]: where it is, nothing while it is not there.
  std::vector<std::vector<std::optional<Eigen::Vector3d>>> truth_;
  /// extents_[frame][target]; empty where the run tells none.
  std::vector<std::vector<TargetExtent>> extents_;
  std::vector<std::vector<SphereEstimate>> estimates_; ///< [frame][target]
};

} // namespace dewpoint::experiment
