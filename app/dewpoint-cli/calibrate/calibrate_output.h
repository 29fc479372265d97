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
  std::string calibrationFile; ///< calibration file to write; empty: none
  std::string reportFile;      ///< HTML page to write; empty: none
  bool writesProject = false;  ///< also write the calibration into the project file
};

/// Returns whether the inputs of a command are a single project rather than image files.
bool isSingleProject(const std::vector<std::string>& inputs);

/// Adds the options that fill `output` to a command. `ofProject` is true if the command calibrates
/// a project; only then can the calibration be written into the project file.
void addOutputOptions(CLI::App& command, CalibrateOutput& output, bool ofProject);

/// Writes all requested files, and returns the first error. Call this only at the end, so that an
/// interrupted calibration changes no file.
Status writeCalibrated(const CalibrateOutput& output, const Project& calibrated,
                       const std::string& reportHtml);

/// Returns a progress function that shows the stages of a computation as progress bars, and ends
/// the computation on Ctrl-C.
CalibrationProgress interruptibleProgress();

/// Prints `sentence`, which states the calibration accuracy or why it is unknown. Then prints the
/// factor by which the accuracy was widened, if any, and the faults that were detected.
void printAccuracy(const std::optional<CalibrationAccuracy>& accuracy, const std::string& sentence,
                   const std::vector<DetectedFault>& faults);

/// Prints an error of a calibration and returns the exit code. After Ctrl-C, prints only that
/// nothing was changed, and returns kExitInterrupted.
int reportCalibrationError(const Error& error);

} // namespace dewpoint::app
