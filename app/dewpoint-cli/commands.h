// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// The commands, one line each, in the folder that says what they are for. Each function adds its
// subcommand to `app`; when that is the chosen one, it stores what the process returns (ExitCode)
// in `exitCode`.

// project/: a project and its targets.
void addNewCommand(CLI::App& app, int& exitCode);
void addLearnColorCommand(CLI::App& app, int& exitCode);
void addDoctorCommand(CLI::App& app, int& exitCode);
/// Of this computer, without a project.
void addSelfTestCommand(CLI::App& app, int& exitCode);

// calibrate/: the cameras, and where another one would help.
void addCalibrateCommand(CLI::App& app, int& exitCode);
void addCalibrationCommand(CLI::App& app, int& exitCode);
/// Below `calibration`, which it makes when it is not there yet.
void addPrintBoardCommand(CLI::App& app, int& exitCode);
void addPlanCommand(CLI::App& app, int& exitCode);

// track/: runs over recordings.
void addTrackCommand(CLI::App& app, int& exitCode);
void addTrackBackwardsCommand(CLI::App& app, int& exitCode);
void addTrackPositionsCommand(CLI::App& app, int& exitCode);
void addTrackBoxCommand(CLI::App& app, int& exitCode);
void addPeopleCommand(CLI::App& app, int& exitCode);

// trajectory/: what a run has written.
void addEvaluateCommand(CLI::App& app, int& exitCode);
void addExportCommand(CLI::App& app, int& exitCode);
/// The results of many jobs as one table and one report.
void addGatherCommand(CLI::App& app, int& exitCode);

// simulate/: recordings with known truth.
void addSimulateCommand(CLI::App& app, int& exitCode);

// experiment/: the experiments of the papers, and the accuracy suite.
void addExperimentCommand(CLI::App& app, int& exitCode);
void addSuiteCommand(CLI::App& app, int& exitCode);

// reference/: pages of the manual.
/// Its pages show the commands that `app` has when it runs.
void addReferenceCommand(CLI::App& app, int& exitCode);

} // namespace dewpoint::app
