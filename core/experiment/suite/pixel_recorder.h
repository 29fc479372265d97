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
/// cameras of the run's rig. An estimate is on its marks when the target is declared present and
/// each of its projections is within the run's gate. Estimates are assigned in the order of the
/// targets, so no two targets may be identical.
class PixelRecorder {
public:
  /// Prepares to record a run. If the run has no marks, nothing is recorded.
  explicit PixelRecorder(const ScenarioRun& run);

  /// Adds the estimates for one frame of the run. Frames without marks are skipped.
  void add(std::int64_t frame, const std::vector<SphereEstimate>& estimates);

  /// Returns the RMS distance of the projections from the marks, pixels. It covers all marks in
  /// frames in which the target is declared present, from each target's convergence on (from the
  /// start if it never converges). Nothing if there are no such marks.
  SuiteRow::Value rmsePx() const;

  /// Returns the result of a run that has only marks. It contains no lengths, but convergence, loss
  /// and the reliability of P(exists), all measured with the marks.
  SuiteResult result(RunKey key, double usPerFrame) const;

private:
  /// Sample of one target in one frame with marks. Samples are in frame order.
  struct Sample {
    bool declared = false;
    double existence = 0.0;
    double worst =
        0.0; ///< largest distance, pixels; infinite if a projection is not in front of the camera
    std::vector<double> distances; ///< distance from each mark, pixels
  };

  std::vector<TargetFrame> framesOf(std::size_t target) const;

  std::map<std::int64_t, std::vector<MarkedCenter>> marks_; ///< by frame
  std::vector<Projector> cameras_;
  double gate_ = 0.0;
  std::vector<std::vector<Sample>> samples_; ///< per target
};

} // namespace dewpoint::experiment
