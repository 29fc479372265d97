// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_status.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Way to calibrate the cameras of a project.
enum class CalibrationProcedure { Grid, Points, Board, Wand, File };

/// Step of a CalibrationProcedure (way to calibrate). Each procedure is a sequence of some of these
/// steps.
enum class GuideStep {
  ImportFile,     ///< read a calibration made with another tool
  PrintBoard,     ///< print a board and glue it to something flat
  LensesByBoard,  ///< show the board to each camera
  FieldOfView,    ///< enter the focal length or field of view
  GridOnFloor,    ///< lay the drawn reference grid over the real floor in each image
  MeasurePoints,  ///< measure points and click them
  ComputeCameras, ///< compute the poses of the cameras from the points
  BoardInVolume,  ///< show the board to several cameras at a time
  RoughPositions, ///< place the cameras roughly
  LearnBall,      ///< learn the color of the ball
  WaveWand,       ///< wave the ball or the stick
  Floor,          ///< set the floor and the origin of the world frame
  MeasuredLength  ///< compare a distance measured in the room with the calibration
};

/// Progress of a calibration step. The step is done when `doneCount` has reached `totalCount`.
struct StepProgress {
  int doneCount = 0;
  int totalCount = 1;
  /// Calibration error after this step, in the unit that errorUnit() returns: pixels, meters, or a
  /// fraction. Empty if unknown.
  std::optional<double> error;

  bool isDone() const { return doneCount >= totalCount; }
  bool operator==(const StepProgress&) const = default;
};

/// Unit of the calibration error after a step.
enum class StepErrorUnit { None, Pixels, Meters, Fraction };
/// Returns the unit of StepProgress::error for a step.
StepErrorUnit errorUnit(GuideStep step);

/// Returns the steps of a way to calibrate, in order.
const std::vector<GuideStep>& stepsOf(CalibrationProcedure procedure);

/// Returns the progress of a calibration step. `status` is the calibrationStatus() of the same
/// project.
StepProgress progressOf(GuideStep step, const Project& project, const CalibrationStatus& status);

/// Returns the first step of a way to calibrate that is not done, or the last step if all steps are
/// done.
GuideStep nextStep(CalibrationProcedure procedure, const Project& project,
                   const CalibrationStatus& status);

/// Returns the procedure by which most camera poses were calibrated; nothing if none is recorded.
std::optional<CalibrationProcedure> procedureInUse(const CalibrationStatus& status);

} // namespace dewpoint::setup
