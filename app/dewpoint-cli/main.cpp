// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/describe_option.h"
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/usage_sentence.h"
#include "app/wiring/quiet_libraries.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <exception>

namespace dewpoint::app {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Dewpoint: tracks colored objects in 3D with particle filters.", "dewpoint-cli");
  app.set_version_flag("--version", std::string("dewpoint-cli ") + DEWPOINT_VERSION);
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 a check found a problem, 2 wrong command line, 3 bad input, 4 "
             "the input ended early,\nor results are missing (all other results are kept), 5 the "
             "output cannot be written, 130 interrupted.");
  int exitCode = kExitDone;
  addNewCommand(app, exitCode);
  addDoctorCommand(app, exitCode);
  addSelfTestCommand(app, exitCode);
  addTrackCommand(app, exitCode);
  addLiveCommand(app, exitCode);
  addTrackBackwardsCommand(app, exitCode);
  addTrackPositionsCommand(app, exitCode);
  addTrackBoxCommand(app, exitCode);
  addRecordCommand(app, exitCode);
  addTakeCommand(app, exitCode);
  addEvaluateCommand(app, exitCode);
  addSimulateCommand(app, exitCode);
  addExperimentCommand(app, exitCode);
  addSuiteCommand(app, exitCode);
  addPeopleCommand(app, exitCode);
  addExportCommand(app, exitCode);
  addGatherCommand(app, exitCode);
  addLearnColorCommand(app, exitCode);
  addCalibrateCommand(app, exitCode);
  addCalibrationCommand(app, exitCode);
  addPlanCommand(app, exitCode);
  addPrintBoardCommand(app, exitCode);
  addReferenceCommand(app, exitCode);
  addDescribeOption(app, "dewpoint");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    app.failure_message([&app](const CLI::App*, const CLI::Error& failed) {
      const auto* parsing = dynamic_cast<const CLI::ParseError*>(&failed);
      return parsing != nullptr ? describeUsageError(app, *parsing) : std::string(failed.what());
    });
    return app.exit(error) == 0 ? kExitDone : kExitUsage;
  }
  return exitCode;
}

} // namespace
} // namespace dewpoint::app

int main(int argc, char** argv) {
  dewpoint::app::silenceLibraries();
  try {
    return dewpoint::app::run(argc, argv);
  } catch (const std::exception& error) {
    // Nothing below throws on purpose; this is memory running out and the like.
    fmt::print(stderr, "dewpoint-cli: stopped: {}.\n", error.what());
    return dewpoint::app::kExitBadInput;
  }
}
