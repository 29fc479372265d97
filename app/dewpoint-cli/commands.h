// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <CLI/App.hpp>

#include <filesystem>

namespace dewpoint::simulation {
struct OfficeScene;
} // namespace dewpoint::simulation

namespace dewpoint::app {

/// What the process returns, as promised by --help.
enum ExitCode {
  kExitDone = 0,
  kExitUsage = 2,      ///< the command line cannot be understood
  kExitBadInput = 3,   ///< nothing could be computed
  kExitEndedEarly = 4, ///< the input broke off; what came before is kept
  kExitOutput = 5,     ///< the output cannot be written; what was written so far is kept
  kExitInterrupted = 130,
};

/// Prints the error's sentence to stderr and returns the exit code that fits it.
int report(const Error& error);

/// Each adds its subcommand; the chosen one stores what to return in `exitCode`.
void addNewCommand(CLI::App& app, int& exitCode);
void addPlanCommand(CLI::App& app, int& exitCode);
void addTrackCommand(CLI::App& app, int& exitCode);
void addTrackPositionsCommand(CLI::App& app, int& exitCode);
void addEvaluateCommand(CLI::App& app, int& exitCode);
void addSimulateCommand(CLI::App& app, int& exitCode);
void addExperimentCommand(CLI::App& app, int& exitCode);
/// The figures of the papers, as subcommands of `experiment`.
void addFigureCommands(CLI::App& group, int& exitCode);
void addSuiteCommand(CLI::App& app, int& exitCode);
void addPeopleCommand(CLI::App& app, int& exitCode);
void addExportCommand(CLI::App& app, int& exitCode);
void addLearnColorCommand(CLI::App& app, int& exitCode);
/// Below `calibration`, which it makes when it is not there yet.
void addPrintBoardCommand(CLI::App& app, int& exitCode);
void addCalibrateCommand(CLI::App& app, int& exitCode);
void addCalibrationCommand(CLI::App& app, int& exitCode);

/// The same into the group `calibrate`.
void addCalibrateIntrinsicsCommand(CLI::App& group, int& exitCode);
void addCalibrateExtrinsicsCommand(CLI::App& group, int& exitCode);
void addCalibrateWandCommand(CLI::App& group, int& exitCode);
void addCalibratePointsCommand(CLI::App& group, int& exitCode);

/// Writes a simulated office scene with people to disk, ready to track: a video per camera,
/// pictures of the empty room, project.toml, calibration.toml, truth.csv. `option` is the one that
/// names the folder. Returns the exit code.
int recordOffice(const OfficeScene& scene, const std::filesystem::path& folder,
                 const std::string& option);

/// Into the group `experiment`.
void addPeopleExperiments(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
