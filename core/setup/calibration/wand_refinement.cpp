// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_refinement.h"

#include "core/base/statistics.h"
#include "core/base/units.h"
#include "core/calibration/report/wand_report.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/calibrated_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace dewpoint::setup {
namespace {

// What makes a camera stand out from the others. Chosen: calibrations often have rotation errors of
// less than 1.5 degrees (docs/calibration.md, cameras that cannot agree).
constexpr double kFarRotation = 1.5 * kDegree; ///< radians
constexpr double kFarDistance = 0.05;          ///< meters
constexpr double kFarFactor = 3.0;             ///< times the median of the others
constexpr std::size_t kLeastCamerasToCompare = 3;

/// How far the image points are from the projections of the positions that explain them best with
/// the former cameras. Gross errors have been dropped already.
std::optional<double> errorBefore(const WandOptions& options, const CameraRig& before,
                                  const WandResult& result) {
  const bool onlyCameras = !options.findOffsets && !result.floorFound && !result.freeFall &&
                           result.scale != WandScale::Distance &&
                           result.scale != WandScale::Diameter;
  if (!onlyCameras || before.size() != result.problem.cameras.size()) {
    return std::nullopt;
  }
  BundleProblem problem = result.problem;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double offset = problem.cameras[k].offset;
    problem.cameras[k] = {.camera = before[k], .poseFixed = true, .offset = offset};
  }
  for (BundleState& state : problem.states) {
    state.known = false; // the solution's positions are no start in the former world
  }
  problem.draft = true;
  const auto adjusted = adjustBundle(problem);
  return adjusted ? std::optional(adjusted->rms) : std::nullopt;
}

Result<WandRefinement> assessed(const Project& project, const WandOptions& options,
                                Result<WandResult> result) {
  if (!result) {
    return tl::make_unexpected(std::move(result.error()));
  }
  CameraRig before = rigOf(project);
  auto accuracy = assessWand(*result, options.floorTimes);
  const auto beforePx = errorBefore(options, before, *result);
  return WandRefinement{options, std::move(before), std::move(*result), std::move(accuracy),
                        beforePx};
}

void recordCameras(const WandRefinement& refinement, Project& project) {
  const BundleResult& bundle = refinement.result.bundle;
  const auto sigmaOf = [&](std::size_t k) {
    return refinement.accuracy && k < refinement.accuracy->cameras.size()
               ? refinement.accuracy->cameras[k].positionSigma
               : bundle.noiseFactor * centerSigma(bundle.covariance, k);
  };
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    ProjectCamera& camera = project.cameras[k];
    const double sigma = sigmaOf(k);
    camera.calibrated.pose = recordOfPose(camera.camera, CalibrationOrigin::Wand,
                                          sigma > 0.0 ? std::optional(sigma) : std::nullopt);
    if (refinement.options.findFocal || refinement.options.findDistortion) {
      camera.calibrated.lens = recordOfLens(camera.camera, CalibrationOrigin::Wand);
    }
  }
}

void recordWorld(const WandRefinement& refinement, WorldRecord& world) {
  const auto& accuracy = refinement.accuracy;
  if (refinement.result.scale != WandScale::InitialRig) {
    world.scale = CalibrationOrigin::Wand;
    world.scaleError = accuracy ? accuracy->scale95 : std::nullopt;
    world.check.reset();
  }
  if (refinement.result.floorFound || refinement.result.freeFall) {
    world.floor = CalibrationOrigin::Wand;
  }
  world.accuracy = accuracy ? std::optional(accuracy->position95) : std::nullopt;
}

} // namespace

bool isInaccurate(const WandRefinement& refinement) {
  return refinement.accuracy &&
         refinement.accuracy->cameras95 > refinement.options.initialPositionError;
}

bool isUnneeded(const WandRefinement& refinement) {
  return refinement.beforePx && refinement.accuracy && refinement.accuracy->heldOut > 0 &&
         *refinement.beforePx <= refinement.accuracy->heldOutPx;
}

std::string unneededText(const WandRefinement& refinement) {
  return fmt::format("the cameras as they were explain the images as well ({:.2f} px; the new ones "
                     "{:.2f} px in images that they were not computed from): keep them, or wave "
                     "longer and through more of the volume",
                     refinement.beforePx.value_or(0.0),
                     refinement.accuracy ? refinement.accuracy->heldOutPx : 0.0);
}

std::vector<FarOffCamera> farOffCameras(const WandRefinement& refinement) {
  const CameraRig& after = refinement.result.cameras;
  std::vector<PoseShift> shifts;
  for (std::size_t k = 0; k < std::min(after.size(), refinement.before.size()); ++k) {
    shifts.push_back(poseShift(refinement.before[k], after[k]));
  }
  std::vector<FarOffCamera> found;
  for (std::size_t k = 0; shifts.size() >= kLeastCamerasToCompare && k < shifts.size(); ++k) {
    std::vector<double> rotations;
    std::vector<double> distances;
    for (std::size_t other = 0; other < shifts.size(); ++other) {
      if (other != k) {
        rotations.push_back(shifts[other].radians);
        distances.push_back(shifts[other].meters);
      }
    }
    if (shifts[k].radians >= std::max(kFarRotation, kFarFactor * upperMedian(rotations)) ||
        shifts[k].meters >= std::max(kFarDistance, kFarFactor * upperMedian(distances))) {
      found.push_back({k, shifts[k]});
    }
  }
  return found;
}

std::string farOffText(const FarOffCamera& camera, const CameraRig& rig) {
  return fmt::format("{} was far off: the refinement rotates it by {:.1f} degrees and moves it by "
                     "{:.1f} cm, much more than the others. Was it moved after its calibration?",
                     rig.at(camera.camera).name, inDegrees(camera.shift.radians),
                     inCentimeters(camera.shift.meters));
}

bool isDoubtful(const WandRefinement& refinement) {
  return !refinement.result.faults.empty() || isInaccurate(refinement) || isUnneeded(refinement);
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

Project withRefinement(Project project, const WandRefinement& refinement) {
  const WandResult& result = refinement.result;
  project = withCameras(std::move(project), result.cameras);
  if (refinement.options.findOffsets) {
    project = withTimeOffsets(std::move(project), result.offsets);
  }
  recordCameras(refinement, project);
  recordWorld(refinement, project.calibrated);
  return project;
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
