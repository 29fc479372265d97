// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// Functions that add the subcommands of `experiment` to `group`. When a subcommand runs, it stores
// the exit code of the process (ExitCode) in `exitCode`.
/// Adds the commands that reproduce the figures in the papers.
void addFigureCommands(CLI::App& group, int& exitCode);
/// Adds a command `people-<scenario>` for each scenario with people.
void addPeopleExperiments(CLI::App& group, int& exitCode);
/// Adds the command `sugandi-rmse`, the study of methods that track boxes.
void addSugandiExperiment(CLI::App& group, int& exitCode);
/// Adds the command `fingerprint`, which prints a checksum of the results of each method.
void addFingerprintCommand(CLI::App& group, int& exitCode);
/// Adds the command `seeds`, which prints the seeds used for tuning, validation and reports.
void addSeedsCommand(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
