// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/manual/camera_variation.h"
#include "core/calibration/quality/calibration_accuracy.h"
#include "core/calibration/quality/missing_motion.h"
#include "core/setup/calibration/wand_views.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Calibration with a wand (a colored ball, or a stick with two balls, that is waved), with
/// everything that the command line and the window report about it.
struct WandRefinement {
  WandOptions options;
  CameraRig camerasBefore; ///< cameras of the project before the calibration
  WandResult result;
  Result<CalibrationAccuracy> accuracy; ///< accuracy, or the reason why there is none
  /// Root mean square reprojection error of the same image points with the cameras `camerasBefore`,
  /// pixels. Empty if anything besides poses and intrinsics was estimated: time offsets, the scale,
  /// or the floor.
  std::optional<double> beforePx = std::nullopt;
  /// True if the poses of all cameras in `camerasBefore` were measured or read from a file, and
  /// have not been changed since then.
  bool wasCalibratedBefore = false;
  /// Largest recorded error of the camera positions in `camerasBefore` (PoseRecord::error), meters;
  /// empty if no error is recorded.
  std::optional<double> beforeError = std::nullopt;
  /// Kinds of motion that the recording lacks; see findMissingMotion().
  std::vector<MotionGap> gaps = {};
};

/// Returns whether the former calibration should be kept, because the new one is probably less
/// accurate. This is the case if the assessed error of the camera positions is larger than their
/// possible error before the calibration, WandOptions::initialPositionError.
bool isInaccurate(const WandRefinement& refinement);

/// Returns whether the recording gives no reason to change the calibration. This is the case if the
/// reprojection error of the old calibration is at most the cross-validated error of the new one,
/// in images that were left out of its computation (CalibrationAccuracy::leftOutRmsPx).
bool isUnnecessary(const WandRefinement& refinement);

/// Returns a sentence that says that the old cameras fit the images as well as the new ones.
std::string unnecessaryRefinementText(const WandRefinement& refinement);

/// Returns whether the old cameras (`wasCalibratedBefore`) are known more accurately than the new
/// ones, and the images do not contradict the old ones. The old cameras are known more accurately
/// in two cases. In the first case, their recorded error is smaller than that of the new positions
/// (CameraAccuracy::positionSigma). In the second case, no error is recorded, and the recording
/// lacks at least half of the motion that is required of some kind (MotionGap::severity).
///
/// The images contradict the old cameras if the old reprojection error is at least three times the
/// new one. A camera was then probably moved. Errors that all images share cause smaller
/// differences, for example if hands always hide the same part of a ball.
bool areOldCamerasMoreAccurate(const WandRefinement& refinement);

/// Returns a sentence that says that the old cameras are known more accurately.
std::string oldCamerasMoreAccurateText(const WandRefinement& refinement);

/// Returns the largest standard deviation of the new camera positions, meters; 0 if it is unknown.
double newPositionError(const WandRefinement& refinement);

/// Camera whose pose before the refinement was far off.
struct FarOffCamera {
  std::size_t camera = 0; ///< index in the rig
  PoseShift poseChange;   ///< change of the pose by the refinement
};

/// Returns the cameras that the refinement rotated by at least 1.5 degrees, or moved by at least 5
/// cm, and at least three times as much as the median of the other cameras. Empty if there are
/// fewer than three cameras, because two cameras do not show which of them was far off.
std::vector<FarOffCamera> farOffCameras(const WandRefinement& refinement);

/// Returns a sentence that names a camera whose pose was far off. `rig` contains the names.
std::string farOffText(const FarOffCamera& camera, const CameraRig& rig);

/// Returns whether a known fault, such as exchanged cameras, explains the views better than this
/// result does, or isInaccurate(), isUnnecessary() or areOldCamerasMoreAccurate() is true. If so,
/// ask the user before you store the result in the project.
bool isDoubtful(const WandRefinement& refinement);

/// Calibrates the cameras from a recording of a wand (calibrateFromRecording()), and assesses the
/// accuracy. Returns the errors of the calibration.
Result<WandRefinement> refineFromRecording(const Project& project, FrameSetSource& source,
                                           const WandOptions& options,
                                           const WandCalibrationCallback& callback = nullptr);

/// Calibrates the cameras from the wand detections of a WandCollector (calibrateFromViews()), and
/// assesses the accuracy.
Result<WandRefinement> refineFromViews(const Project& project,
                                       const std::vector<std::vector<MarkerObservation>>& views,
                                       const WandOptions& options,
                                       const WandCalibrationCallback& callback = nullptr);

/// Returns `project` with the calibration of the refinement: poses, intrinsics, delays if they were
/// requested, and the records of their origin. `project` must have the same cameras as the project
/// that was calibrated.
Project withRefinement(Project project, const WandRefinement& refinement);

/// Returns, for each camera, the regions of its image that contain ball detections used in the
/// calibration.
std::vector<BoardCoverage> ballCoverageOf(const WandResult& result);

/// Returns the report about a wand calibration as one self-contained HTML page.
std::string htmlText(const WandRefinement& refinement);

} // namespace dewpoint::setup
