// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/quality/calibration_accuracy.h"
#include "core/setup/calibration/board_calibration.h"
#include "core/setup/calibration/missed_images.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Quantities that a calibration with a board estimates. At least one must be true.
struct BoardGoal {
  bool estimatesLenses = true; ///< estimate the intrinsics
  bool estimatesPoses = false; ///< estimate the poses

  bool operator==(const BoardGoal&) const = default;
};

/// A project calibrated with a board, and the report about it.
struct BoardOutcome {
  Project project;
  std::optional<LensesFromBoards> lenses;
  std::optional<ExtrinsicsResult> extrinsics;
  std::optional<Error> extrinsicsError; ///< reason why only the intrinsics were estimated although
                                        ///< both were requested
  /// Accuracy of the camera positions; empty if it could not be assessed.
  std::optional<CalibrationAccuracy> accuracy;
  /// Sentence with the accuracy, or with the reason why there is none. Empty if no camera poses
  /// were estimated.
  std::string accuracySummary;
  std::string report; ///< report about the calibration, a single HTML page
  /// For each camera, the images in which it did not see the board; set if intrinsics were
  /// requested.
  std::vector<std::vector<MissedRun>> missedRuns;
};

/// Estimates intrinsics, then poses with these intrinsics, from board detections. The command line
/// and the window give bit-identical results, for recordings and live cameras. The given project is
/// not changed. The pose of a single camera can be estimated only if the board lies on the floor in
/// at least one view. Returns the errors of intrinsicsFromBoards() and extrinsicsFromBoards().
Result<BoardOutcome> calibrateFromBoards(const Project& project, const BoardDetections& seen,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// Searches for the board in a recording, and estimates intrinsics and then poses from the
/// detections. Errors are those of the search (findBoards()) and of the calibration.
Result<BoardOutcome> calibrateFromBoards(const Project& project, FrameSetSource& source,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// Returns whether a known fault, such as exchanged cameras, explains the detections better than
/// this result does. If so, ask the user before you store the result in the project.
bool isDoubtful(const BoardOutcome& outcome);

/// Returns `project` with the calibration of the outcome. `project` must have the same cameras as
/// the project that was calibrated.
Project withOutcome(Project project, const BoardOutcome& outcome);

/// Returns sentences about what the user should know in addition to the numbers: cameras that kept
/// their calibration, notices, and faults.
std::vector<std::string> outcomeRemarks(const BoardOutcome& outcome);

} // namespace dewpoint::setup
