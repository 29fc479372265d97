// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

// Functions that add the subcommands of `calibrate` to `group`. When a subcommand runs, it stores
// the exit code of the process (ExitCode) in `exitCode`.
void addCalibrateIntrinsicsCommand(CLI::App& group, int& exitCode);
void addCalibrateExtrinsicsCommand(CLI::App& group, int& exitCode);
void addCalibrateWandCommand(CLI::App& group, int& exitCode);
void addCalibratePointsCommand(CLI::App& group, int& exitCode);
void addCalibrateWorldCommand(CLI::App& group, int& exitCode);
void addCalibrateStatusCommand(CLI::App& group, int& exitCode);
void addFindBoardCommand(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
