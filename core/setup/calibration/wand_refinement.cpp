// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_refinement.h"

#include "core/calibration/report/wand_report.h"
#include "core/project/project_rig.h"

namespace dewpoint::setup {
namespace {

Result<WandRefinement> assessed(const Project& project, const WandOptions& options,
                                Result<WandResult> result) {
  if (!result) {
    return tl::make_unexpected(std::move(result.error()));
  }
  CameraRig before = rigOf(project);
  auto accuracy = assessWand(*result, options.floorTimes);
  return WandRefinement{options, std::move(before), std::move(*result), std::move(accuracy)};
}

} // namespace

bool isInaccurate(const WandRefinement& refinement) {
  return refinement.accuracy &&
         refinement.accuracy->cameras95 > refinement.options.initialPositionError;
}

bool isDoubtful(const WandRefinement& refinement) {
  return !refinement.result.faults.empty() || isInaccurate(refinement);
}

Result<WandRefinement> refineFromRecording(const Project& project, FrameSetSource& source,
                                           const WandOptions& options,
                                           const WandCalibrationCallback& callback) {
  return assessed(project, options, calibrateFromRecording(project, source, options, callback));
}

Result<WandRefinement> refineFromViews(const Project& project,
                                       const std::vector<std::vector<MarkerObservation>>& views,
                                       const WandOptions& options,
                                       const WandCalibrationCallback& callback) {
  return assessed(project, options, calibrateFromViews(project, views, options, callback));
}

std::vector<BoardCoverage> coverageOf(const WandResult& result) {
  std::vector<BoardCoverage> coverage(result.cameras.size());
  for (const BundleObservation& seen : result.problem.observations) {
    const Intrinsics& image = result.cameras[seen.camera].intrinsics;
    const int region = BoardCoverage::regionOf(seen.pixel, image.width, image.height);
    ++coverage[seen.camera].corners.at(static_cast<std::size_t>(region));
  }
  return coverage;
}

std::string htmlText(const WandRefinement& refinement) {
  WandReport report;
  report.before = refinement.before;
  report.result = refinement.result;
  report.accuracy = refinement.accuracy
                        ? accuracySummary(*refinement.accuracy)
                        : "Accuracy unknown: " + sentence(refinement.accuracy.error());
  report.coverage = coverageOf(refinement.result);
  report.offsetsFound = refinement.options.findOffsets;
  return htmlText(report);
}

} // namespace dewpoint::setup
