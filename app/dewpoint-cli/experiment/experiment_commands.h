// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// Functions that add the subcommands of `experiment`, one per line, as in commands.h.
/// Adds the commands that reproduce the figures in the papers.
void addFigureCommands(CLI::App& group, int& exitCode);
/// Adds `people-<scenario>` for each scenario with people.
void addPeopleExperiments(CLI::App& group, int& exitCode);
/// Adds `sugandi-rmse`.
void addSugandiExperiment(CLI::App& group, int& exitCode);
/// Adds `fingerprint`, which prints a checksum of the results of each method.
void addFingerprintCommand(CLI::App& group, int& exitCode);
/// Adds `seeds`, which prints the seeds used for tuning, validation and reports.
void addSeedsCommand(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
