// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_refinement.h"

#include "core/base/statistics.h"
#include "core/base/uncertainty_text.h"
#include "core/base/units.h"
#include "core/calibration/report/wand_report.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/calibrated_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

// When the former cameras are kept. Chosen: in simulated recordings of a thrown ball, half hidden
// by hands, good cameras leave 1.3 to 2 times the error of those that were fitted to such images
// (ThrownBall in the tests); a camera that was moved by a centimeter leaves much more.
constexpr double kContradicted = 3.0;
constexpr double kSevereGap = 0.5; ///< MotionGap::severity

/// How far the image points are from the projections of the positions that explain them best with
/// the former cameras. Gross errors have been dropped already.
std::optional<double> errorBefore(const WandOptions& options, const CameraRig& before,
                                  const WandResult& result) {
  const bool onlyCameras = !options.estimatesTimeOffsets && !result.isFloorFound &&
                           !result.freeFall && result.scaleMethod != WandScale::Distance &&
                           result.scaleMethod != WandScale::Diameter;
  if (!onlyCameras || before.size() != result.problem.cameras.size()) {
    return std::nullopt;
  }
  BundleProblem problem = result.problem;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double offset = problem.cameras[k].timeOffset;
    problem.cameras[k] = {.camera = before[k], .isPoseFixed = true, .timeOffset = offset};
  }
  for (BundleState& state : problem.states) {
    state.isPositionKnown = false; // the solution's positions are no start in the former world
  }
  problem.isDraft = true;
  const auto adjusted = adjustBundle(problem);
  return adjusted ? std::optional(adjusted->rmsPx) : std::nullopt;
}

/// What the project records about the former cameras.
void addRecords(const Project& project, WandRefinement& refinement) {
  refinement.wasCalibratedBefore = !project.cameras.empty();
  for (const ProjectCamera& camera : project.cameras) {
    const auto& pose = camera.calibrationRecord.pose;
    if (!pose || !describes(*pose, camera.camera)) {
      refinement.wasCalibratedBefore = false;
      refinement.beforeError.reset();
      return;
    }
    if (pose->error && std::isfinite(*pose->error)) {
      refinement.beforeError = std::max(refinement.beforeError.value_or(0.0), *pose->error);
    }
  }
}

Result<WandRefinement> assessed(const Project& project, const WandOptions& options,
                                Result<WandResult> result) {
  if (!result) {
    return tl::make_unexpected(std::move(result.error()));
  }
  CameraRig before = rigOf(project);
  WandRefinement refinement;
  refinement.options = options;
  refinement.accuracy = assessWand(*result, options.floorTimes);
  refinement.beforePx = errorBefore(options, before, *result);
  refinement.gaps = findMissingMotion(*result);
  refinement.camerasBefore = std::move(before);
  refinement.result = std::move(*result);
  addRecords(project, refinement);
  return refinement;
}

void recordCameras(const WandRefinement& refinement, Project& project) {
  const BundleResult& bundle = refinement.result.bundle;
  const auto sigmaOf = [&](std::size_t k) {
    return refinement.accuracy && k < refinement.accuracy->cameras.size()
               ? refinement.accuracy->cameras[k].positionSigma
               : bundle.residualToSigmaRatio * centerSigma(bundle.covariance, k);
  };
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    ProjectCamera& camera = project.cameras[k];
    const double sigma = sigmaOf(k);
    camera.calibrationRecord.pose = recordOfPose(camera.camera, CalibrationOrigin::Wand,
                                                 sigma > 0.0 ? std::optional(sigma) : std::nullopt);
    if (refinement.options.estimatesFocalLengths || refinement.options.estimatesDistortion) {
      camera.calibrationRecord.lens = recordOfLens(camera.camera, CalibrationOrigin::Wand);
    }
  }
}

void recordWorld(const WandRefinement& refinement, WorldRecord& world) {
  const auto& accuracy = refinement.accuracy;
  if (refinement.result.scaleMethod != WandScale::InitialRig) {
    world.scaleOrigin = CalibrationOrigin::Wand;
    world.scaleError = accuracy ? accuracy->scaleError95 : std::nullopt;
    world.lengthCheck.reset();
  }
  if (refinement.result.isFloorFound || refinement.result.freeFall) {
    world.floorOrigin = CalibrationOrigin::Wand;
  }
  world.errorInsideVolume = accuracy ? std::optional(accuracy->positionError95) : std::nullopt;
  world.errorOutsideVolume = accuracy ? accuracy->outsidePositionError95 : std::nullopt;
}

} // namespace

bool isInaccurate(const WandRefinement& refinement) {
  return refinement.accuracy &&
         refinement.accuracy->positionErrorFromCameras95 > refinement.options.initialPositionError;
}

bool isUnnecessary(const WandRefinement& refinement) {
  return refinement.beforePx && refinement.accuracy && refinement.accuracy->leftOutPointCount > 0 &&
         *refinement.beforePx <= refinement.accuracy->leftOutRmsPx;
}

std::string unnecessaryRefinementText(const WandRefinement& refinement) {
  return fmt::format("the old cameras fit the images as well ({:.2f} px) as the new ones ({:.2f} "
                     "px in images that they were not computed from): keep the old ones, or wave "
                     "longer and through more of the volume",
                     refinement.beforePx.value_or(0.0),
                     refinement.accuracy ? refinement.accuracy->leftOutRmsPx : 0.0);
}

double newPositionError(const WandRefinement& refinement) {
  double largest = 0.0;
  if (refinement.accuracy) {
    for (const CameraAccuracy& camera : refinement.accuracy->cameras) {
      largest = std::max(largest, camera.positionSigma);
    }
  }
  return largest;
}

bool areOldCamerasMoreAccurate(const WandRefinement& refinement) {
  if (!refinement.wasCalibratedBefore || !refinement.beforePx || !refinement.accuracy ||
      refinement.accuracy->leftOutPointCount == 0 ||
      *refinement.beforePx >= kContradicted * refinement.accuracy->leftOutRmsPx) {
    return false;
  }
  if (refinement.beforeError) {
    return *refinement.beforeError < newPositionError(refinement);
  }
  return !refinement.gaps.empty() && refinement.gaps.front().severity >= kSevereGap;
}

std::string oldCamerasMoreAccurateText(const WandRefinement& refinement) {
  if (!refinement.beforeError) {
    return "the cameras were calibrated before, and the motion in this recording is not enough to "
           "improve that calibration: keep the old cameras";
  }
  return fmt::format("the old camera positions are known more accurately ({}) than the new ones "
                     "({}): keep the old ones",
                     lengthUncertaintyText(*refinement.beforeError),
                     lengthUncertaintyText(newPositionError(refinement)));
}

std::vector<FarOffCamera> farOffCameras(const WandRefinement& refinement) {
  const CameraRig& after = refinement.result.cameras;
  std::vector<PoseShift> shifts;
  for (std::size_t k = 0; k < std::min(after.size(), refinement.camerasBefore.size()); ++k) {
    shifts.push_back(poseShift(refinement.camerasBefore[k], after[k]));
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
                     rig.at(camera.camera).name, inDegrees(camera.poseChange.radians),
                     inCentimeters(camera.poseChange.meters));
}

bool isDoubtful(const WandRefinement& refinement) {
  return !refinement.result.faults.empty() || isInaccurate(refinement) ||
         isUnnecessary(refinement) || areOldCamerasMoreAccurate(refinement);
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
  if (refinement.options.estimatesTimeOffsets) {
    project = withTimeOffsets(std::move(project), result.timeOffsets);
  }
  recordCameras(refinement, project);
  recordWorld(refinement, project.worldRecord);
  return project;
}

std::vector<BoardCoverage> ballCoverageOf(const WandResult& result) {
  std::vector<BoardCoverage> coverage(result.cameras.size());
  for (const BundleObservation& seen : result.problem.observations) {
    const Intrinsics& image = result.cameras[seen.camera].intrinsics;
    const int region = BoardCoverage::regionOf(seen.pixel, image.width, image.height);
    ++coverage[seen.camera].cornerCounts.at(static_cast<std::size_t>(region));
  }
  return coverage;
}

std::string htmlText(const WandRefinement& refinement) {
  WandReport report;
  report.initialRig = refinement.camerasBefore;
  report.result = refinement.result;
  report.accuracyText = refinement.accuracy
                            ? accuracySummary(*refinement.accuracy)
                            : "Accuracy unknown: " + errorSentence(refinement.accuracy.error());
  report.coverage = ballCoverageOf(refinement.result);
  report.hasTimeOffsets = refinement.options.estimatesTimeOffsets;
  for (const MotionGap& gap : refinement.gaps) {
    report.notices.push_back(motionGapText(gap, refinement.camerasBefore));
  }
  return htmlText(report);
}

} // namespace dewpoint::setup
