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

/// A project that was calibrated with a board, and what is to be said about it.
struct BoardOutcome {
  Project project;
  std::optional<LensesFromBoards> lenses;
  std::optional<ExtrinsicsResult> extrinsics;
  std::optional<Error>
      extrinsicsError; ///< why only the lenses were found, although both were wanted
  std::optional<CalibrationAccuracy>
      accuracy;                 ///< of the camera positions; nothing: it could not be assessed
  std::string accuracySentence; ///< or why there is none; empty without places
  std::string report;           ///< one HTML page
};

/// Lenses, then places with these lenses, from where the board was seen: the same bits for the
/// command line and the window, from a recording or live. The project itself is not changed. One
/// camera alone has no place to be found, unless the board lies on the floor somewhere.
/// Errors: those of intrinsicsFromBoards() and extrinsicsFromBoards().
Result<BoardOutcome> calibrateFromBoards(const Project& project, const SeenBoards& seen,
                                         const BoardCalibrationRequest& wish, const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// The same from a recording, in which the board is looked for first. Errors: those of
/// findBoards() too.
Result<BoardOutcome> calibrateFromBoards(const Project& project, FrameSetSource& source,
                                         const BoardCalibrationRequest& wish, const BoardGoal& goal,
                                         const CalibrationProgress& progress = {});

/// Whether a person should decide about it before it is put into the project: a fault that has a
/// name explains what was seen better.
bool isDoubtful(const BoardOutcome& outcome);

/// A project with the same cameras, calibrated as the outcome says.
Project withOutcome(Project project, const BoardOutcome& outcome);

/// What a person should know beside the figures, sentence by sentence: cameras that kept what they
/// had, notices, faults.
std::vector<std::string> remarksOn(const BoardOutcome& outcome);

} // namespace dewpoint::setup
