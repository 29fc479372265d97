// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/commands.h"

#include <CLI/CLI.hpp>

namespace dewpoint::app {

void addCalibrateCommand(CLI::App& app, int& exitCode) {
  auto* group = app.add_subcommand("calibrate", "Calibrate the cameras.");
  group->require_subcommand(1);
  addCalibratePointsCommand(*group, exitCode);
  addFindBoardCommand(*group, exitCode);
  addCalibrateIntrinsicsCommand(*group, exitCode);
  addCalibrateExtrinsicsCommand(*group, exitCode);
  addCalibrateWandCommand(*group, exitCode);
  addCalibrateWorldCommand(*group, exitCode);
  addCalibrateStatusCommand(*group, exitCode);
}

} // namespace dewpoint::app
