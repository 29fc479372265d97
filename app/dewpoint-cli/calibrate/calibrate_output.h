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

/// What the commands below `calibrate` have in common.
struct CalibrateOutput {
  std::string out;    ///< calibration file to write, or empty
  std::string report; ///< HTML page to write, or empty
  bool apply = false; ///< write into the project file itself
};

/// Adds the options for it.
void addOutputOptions(CLI::App& command, CalibrateOutput& output, bool ofProject);

/// Writes what is requested, everything at the end: a calibration that was stopped changes no file.
Status writeCalibrated(const CalibrateOutput& output, const Project& calibrated,
                       const std::string& reportHtml);

/// Shows the stages of a computation as progress bars, and ends it on Ctrl-C.
CalibrationProgress interruptibleProgress();

/// Prints the sentence of the accuracy (or why there is none), what it was widened by, and the
/// faults that have a name.
void printAccuracy(const std::optional<CalibrationAccuracy>& accuracy, const std::string& sentence,
                   const std::vector<NamedFault>& faults);

/// What the process returns after an error: kExitInterrupted when it was Ctrl-C, without a word
/// besides that nothing was changed.
int reportCalibration(const Error& error);

} // namespace dewpoint::app
