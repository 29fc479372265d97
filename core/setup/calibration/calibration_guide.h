// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_status.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Way to calibrate the cameras of a project.
enum class CalibrationProcedure { Grid, Points, Board, Wand, File };

/// Step of a CalibrationProcedure. Each way is a sequence of some of these steps.
enum class GuideStep {
  ImportFile,     ///< read a calibration made with another tool
  PrintBoard,     ///< print a board and glue it to something flat
  LensesByBoard,  ///< show the board to each camera
  FieldOfView,    ///< enter the focal length or field of view
  GridOnFloor,    ///< lay the grid over the room in each image
  MeasurePoints,  ///< measure points and click them
  ComputeCameras, ///< compute the poses of the cameras from the points
  BoardInVolume,  ///< show the board to several cameras at a time
  RoughPositions, ///< place the cameras roughly
  LearnBall,      ///< learn the color of the ball
  WaveWand,       ///< wave the ball or the stick
  Floor,          ///< set floor and origin
  MeasuredLength  ///< compare a measured distance
};

/// Progress of a step. The step is done when `done` has reached `total`.
struct StepProgress {
  int done = 0;
  int total = 1;
  /// Error of the step in the unit errorUnit(): pixels, meters, or a fraction.
  std::optional<double> error;

  bool isDone() const { return done >= total; }
  bool operator==(const StepProgress&) const = default;
};

/// Unit of the error of a step.
enum class StepErrorUnit { None, Pixels, Meters, Fraction };
/// Returns the unit of StepProgress::error for a step.
StepErrorUnit errorUnit(GuideStep step);

/// Returns the steps of a way, in order.
const std::vector<GuideStep>& stepsOf(CalibrationProcedure procedure);

/// Returns the progress of a step. `status` is the calibrationStatus() of the same project.
StepProgress progressOf(GuideStep step, const Project& project, const CalibrationStatus& status);

/// Returns the first step of a way that is not done, or the last step if all steps are done.
GuideStep nextStep(CalibrationProcedure procedure, const Project& project,
                   const CalibrationStatus& status);

/// Returns the way in which most camera poses were calibrated; nothing if none is recorded.
std::optional<CalibrationProcedure> procedureInUse(const CalibrationStatus& status);

} // namespace dewpoint::setup
