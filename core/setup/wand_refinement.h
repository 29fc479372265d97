// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/manual/pose_change.h"
#include "core/calibration/quality/calibration_accuracy.h"
#include "core/setup/wand_views.h"

#include <string>
#include <vector>

namespace dewpoint::setup {

/// A calibration by wand with its report: what the command line prints and what the
/// window shows.
struct WandRefinement {
  WandOptions options;
  CameraRig before; ///< the project's cameras as they were
  WandResult result;
  Result<CalibrationAccuracy> accuracy; ///< or why there is none
};

/// Whether its cameras are less accurate, by the assessment, than those it began with may be off:
/// then the former ones are better kept.
bool saysTooLittle(const WandRefinement& refinement);

/// Whether the user should decide about it before it is put into the project: a fault that has a
/// name explains the views better, or it says too little.
bool isDoubtful(const WandRefinement& refinement);

/// calibrateFromRecording() and its accuracy. Errors: those of the calibration.
Result<WandRefinement> refineFromRecording(const Project& project, FrameSetSource& source,
                                           const WandOptions& options,
                                           const WandWorkCallback& callback = nullptr);

/// calibrateFromViews() and its accuracy: from what a WandCollector saw.
Result<WandRefinement> refineFromViews(const Project& project,
                                       const std::vector<std::vector<MarkerObservation>>& views,
                                       const WandOptions& options,
                                       const WandWorkCallback& callback = nullptr);

/// Where in each camera's image the balls were that the result rests on.
std::vector<BoardCoverage> coverageOf(const WandResult& result);

/// The report as one self-contained HTML page (htmlText() of wand_report.h).
std::string htmlText(const WandRefinement& refinement);

} // namespace dewpoint::setup
