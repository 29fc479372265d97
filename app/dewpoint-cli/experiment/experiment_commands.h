// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// The subcommands of `experiment`, one line each; as in commands.h.
/// The figures of the papers.
void addFigureCommands(CLI::App& group, int& exitCode);
/// `people-<scenario>`, for each scenario with people.
void addPeopleExperiments(CLI::App& group, int& exitCode);
/// `sugandi-rmse`.
void addSugandiExperiment(CLI::App& group, int& exitCode);
/// `fingerprint`: the states of the methods.
void addFingerprintCommand(CLI::App& group, int& exitCode);
/// `seeds`: the blocks of seeds.
void addSeedsCommand(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
