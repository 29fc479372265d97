// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/calibration_progress.h"
#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/calibration_accuracy.h"
#include "core/project/project.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Output options shared by the commands below `calibrate`.
struct CalibrateOutput {
  std::string out;    ///< calibration file to write; empty: none
  std::string report; ///< HTML page to write; empty: none
  bool apply = false; ///< also write the calibration into the project file
};

/// Returns whether the inputs of a command are one project, not image files.
bool isProject(const std::vector<std::string>& inputs);

/// Adds the options to a command. `ofProject` is true if the command calibrates a project, so that
/// the calibration can be written into the project file.
void addOutputOptions(CLI::App& command, CalibrateOutput& output, bool ofProject);

/// Writes all requested files. It is called at the end, so that an interrupted calibration changes
/// no file.
Status writeCalibrated(const CalibrateOutput& output, const Project& calibrated,
                       const std::string& reportHtml);

/// Returns a function that shows the stages of a computation as progress bars and ends it on
/// Ctrl-C.
CalibrationProgress interruptibleProgress();

/// Prints `sentence`, which gives the accuracy or the reason why there is none. Then prints the
/// factor by which the accuracy was widened, if any, and the faults.
void printAccuracy(const std::optional<CalibrationAccuracy>& accuracy, const std::string& sentence,
                   const std::vector<DetectedFault>& faults);

/// Reports an error and returns the exit code. For Ctrl-C it returns kExitInterrupted and prints
/// only that nothing was changed.
int reportCalibrationError(const Error& error);

} // namespace dewpoint::app
