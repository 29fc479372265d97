// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// Functions that add the commands of the program to `app`, grouped by the folder of their sources.
// When a command runs, it stores the exit code of the process (ExitCode) in `exitCode`.

// project/: a project and its targets.
void addNewCommand(CLI::App& app, int& exitCode);
void addLearnColorCommand(CLI::App& app, int& exitCode);
void addDoctorCommand(CLI::App& app, int& exitCode);
/// Adds the command that tests whether this computer is suitable for tracking. It needs no project.
void addSelfTestCommand(CLI::App& app, int& exitCode);

// calibrate/: camera calibration, and planning where to place another camera.
void addCalibrateCommand(CLI::App& app, int& exitCode);
void addCalibrationCommand(CLI::App& app, int& exitCode);
/// Adds the command that writes a calibration board for printing, as a subcommand of `calibration`,
/// which is created if it does not exist yet.
void addPrintBoardCommand(CLI::App& app, int& exitCode);
void addPlanCommand(CLI::App& app, int& exitCode);

// track/: tracking in recordings and live.
void addTrackCommand(CLI::App& app, int& exitCode);
void addLiveCommand(CLI::App& app, int& exitCode);
void addTrackBackwardsCommand(CLI::App& app, int& exitCode);
void addTrackPositionsCommand(CLI::App& app, int& exitCode);
void addTrackBoxCommand(CLI::App& app, int& exitCode);
void addPeopleCommand(CLI::App& app, int& exitCode);

// live/: live cameras.
/// Adds the command that lists camera devices and locks their colors.
void addCamerasCommand(CLI::App& app, int& exitCode);
void addRecordCommand(CLI::App& app, int& exitCode);
/// Adds the command that compares a take (a recording of all cameras) with the results that were
/// tracked live.
void addTakeCommand(CLI::App& app, int& exitCode);

// trajectory/: commands for the results of a run.
void addEvaluateCommand(CLI::App& app, int& exitCode);
void addExportCommand(CLI::App& app, int& exitCode);
/// Adds the command that combines the results of many jobs into one table and one report.
void addGatherCommand(CLI::App& app, int& exitCode);

// simulate/: recordings with known ground truth.
void addSimulateCommand(CLI::App& app, int& exitCode);

// experiment/: the experiments of the papers, and the accuracy suite.
void addExperimentCommand(CLI::App& app, int& exitCode);
void addSuiteCommand(CLI::App& app, int& exitCode);

// reference/: pages of the manual.
/// Adds the command that writes the reference pages. These describe all commands that `app` has
/// when the command runs.
void addReferenceCommand(CLI::App& app, int& exitCode);

} // namespace dewpoint::app
