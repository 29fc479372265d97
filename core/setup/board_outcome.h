// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/quality/calibration_accuracy.h"
#include "core/setup/board_calibration.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// What is to be found with a board: one of them at least.
struct BoardGoal {
  bool lenses = true;
  bool poses = false;

  bool operator==(const BoardGoal&) const = default;
};

/// A project that was calibrated with a board, and the report about it.
struct BoardOutcome {
  Project project;
  std::optional<LensesFromBoards> lenses;
  std::optional<ExtrinsicsResult> extrinsics;
  std::optional<Error>
      extrinsicsError; ///< why only the lenses were found, although both were wanted
  std::optional<CalibrationAccuracy>
      accuracy;                 ///< of the camera positions; nothing: it could not be assessed
  std::string accuracySentence; ///< or why there is none; empty without camera poses
  std::string report;           ///< one HTML page
};

/// Lenses, then poses with these lenses, from where the board was seen: the same bits for the
/// command line and the window, from a recording or live. The project itself is not changed. One
/// camera alone has no pose to be found, unless the board lies on the floor somewhere. Errors:
/// those of intrinsicsFromBoards() and extrinsicsFromBoards().
Result<BoardOutcome> calibrateFromBoards(const Project& project, const SeenBoards& seen,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// The same from a recording, in which the board is searched for first. Errors: those of
/// findBoards() too.
Result<BoardOutcome> calibrateFromBoards(const Project& project, FrameSetSource& source,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// Whether the user should decide about it before it is put into the project: a fault that has a
/// name explains what was seen better.
bool isDoubtful(const BoardOutcome& outcome);

/// A project with the same cameras, with the calibration of the outcome.
Project withOutcome(Project project, const BoardOutcome& outcome);

/// What the user should know besides the numbers, sentence by sentence: cameras that kept what they
/// had, notices, faults.
std::vector<std::string> remarksOn(const BoardOutcome& outcome);

} // namespace dewpoint::setup
