// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/event_metrics.h"
#include "core/experiment/metrics/reliability.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/experiment/suite/suite_recorder.h"
#include "core/geometry/projector.h"
#include "core/tracking/track_estimate.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Measures the estimates of one method in the images of a run that has marks: its estimates are
/// projected into the cameras of the run's rig. A target is on its marks when it is declared
/// present and every one of its projections is within the run's gate. Estimates go by the order of
/// the targets, so these must not be alike.
class PixelRecorder {
public:
  /// Runs without marks record nothing.
  explicit PixelRecorder(const ScenarioRun& run);

  /// What is believed at a frame of the run; frames without marks are passed over.
  void add(std::int64_t frame, const std::vector<SphereEstimate>& estimates);

  /// RMS distance of the projections from the marks, pixels, over all marks of frames in which the
  /// target is declared present, from each target's convergence on (from the start where it never
  /// converges); nothing without any.
  SuiteRow::Figure rmsePx() const;

  /// The result of a run that has marks alone: no lengths, but convergence, loss and the
  /// reliability of P(exists), all by the marks.
  SuiteResult result(RunKey key, double usPerFrame) const;

private:
  /// One target at one frame with marks, in the order of the frames.
  struct Sample {
    bool declared = false;
    double existence = 0.0;
    double worst = 0.0; ///< px; infinite where a projection is not in front of the camera
    std::vector<double> distances; ///< px, per mark
  };

  std::vector<TargetFrame> framesOf(std::size_t target) const;

  std::map<std::int64_t, std::vector<MarkedCenter>> marks_; ///< by frame
  std::vector<Projector> cameras_;
  double gate_ = 0.0;
  std::vector<std::vector<Sample>> samples_; ///< per target
};

} // namespace dewpoint::experiment
