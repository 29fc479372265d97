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

/// Evaluates one method in the images of a run that has marks. Its estimates are projected into the
/// cameras of the run's rig. A target is on its marks when it is declared present and each of its
/// projections is within the run's gate. Estimates are assigned in the order of the targets, so no
/// two targets may be identical.
class PixelRecorder {
public:
  /// A run without marks records nothing.
  explicit PixelRecorder(const ScenarioRun& run);

  /// Adds the estimates of a frame of the run; frames without marks are skipped.
  void add(std::int64_t frame, const std::vector<SphereEstimate>& estimates);

  /// RMS distance of the projections from the marks, pixels. It covers all marks of frames in which
  /// the target is declared present, from each target's convergence on (from the start if it never
  /// converges). Nothing without such marks.
  SuiteRow::Figure rmsePx() const;

  /// Result of a run that has only marks: no lengths, but convergence, loss and the reliability of
  /// P(exists), all measured by the marks.
  SuiteResult result(RunKey key, double usPerFrame) const;

private:
  /// One target at one frame with marks, in the order of the frames.
  struct Sample {
    bool declared = false;
    double existence = 0.0;
    double worst = 0.0;            ///< px; infinite if a projection is not in front of the camera
    std::vector<double> distances; ///< px, per mark
  };

  std::vector<TargetFrame> framesOf(std::size_t target) const;

  std::map<std::int64_t, std::vector<MarkedCenter>> marks_; ///< by frame
  std::vector<Projector> cameras_;
  double gate_ = 0.0;
  std::vector<std::vector<Sample>> samples_; ///< per target
};

} // namespace dewpoint::experiment
