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

/// Evaluates one method in the images of a run that has marks: true target centers in the images,
/// ScenarioRun::markedCenters. The estimates of the method are projected into the cameras of the
/// run's rig. In a frame with marks, a target is followed if the method declares it present and if,
/// for each mark of the target, the distance to the projection is below ScenarioRun::markGatePx.
/// The estimate with index k is compared with the marks of target k, so no two targets of the run
/// may look the same.
class PixelRecorder {
public:
  /// Creates a recorder for a run. It records nothing if the run has no marks (true target centers
  /// in the images).
  explicit PixelRecorder(const ScenarioRun& run);

  /// Adds the estimates for one frame of the run. Frames without marks (true target centers) are
  /// skipped.
  void add(std::int64_t frame, const std::vector<SphereEstimate>& estimates);

  /// Returns the RMS distance of the projected estimates from the marks (true target centers),
  /// pixels. For each target, the marks from the convergence of its estimate on are used, or all
  /// marks if the estimate never converges. Frames in which the target is not declared present are
  /// left out. Returns nothing if no marks remain.
  SuiteRow::Value rmsePx() const;

  /// Returns the result of a run that has marks (true target centers in the images) but no true
  /// positions in the room. It contains convergence, lost frames and the reliability of P(exists),
  /// all determined with the marks. It contains no lengths in meters.
  SuiteResult result(RunKey key, double usPerFrame) const;

private:
  /// Sample of one target in one frame with marks. Samples are in frame order.
  struct Sample {
    bool isDeclared = false;
    double existenceProbability = 0.0;
    double largestDistancePx =
        0.0; ///< largest distance, pixels; infinite if a projection is not in front of the camera
    std::vector<double> distancesPx; ///< distance from each mark, pixels
  };

  std::vector<TargetFrame> framesOf(std::size_t target) const;

  /// Marks (true target centers in the images), by frame.
  std::map<std::int64_t, std::vector<MarkedCenter>> marks_;
  std::vector<Projector> cameras_;
  double gate_ = 0.0;
  std::vector<std::vector<Sample>> samples_; ///< one list per target, in frame order
};

} // namespace dewpoint::experiment
