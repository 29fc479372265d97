// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/base/thread_count.h"
#include "core/session/take/take_replay.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace dewpoint::app {
namespace {

struct TakeCheckOptions {
  std::string folder;
  int threads = 0;
};

/// Says whether a take that is tracked again gives the live trajectory.
int checkTake(const TakeCheckOptions& options) {
  catchInterruption();
  std::optional<Progress> progress;
  const auto comparison = compareReplay(options.folder, threadCountForFilter(options.threads),
                                        [&](std::int64_t done, std::int64_t total) {
                                          if (!progress) {
                                            progress.emplace("frames", total);
                                          }
                                          progress->show(done);
                                          return !wasInterruptionRequested();
                                        });
  if (progress) {
    progress->finish();
  }
  if (!comparison) {
    return reportError(comparison.error());
  }
  for (const std::string& line : describeReplay(*comparison)) {
    fmt::print("{}\n", line);
  }
  return comparison->isBitIdentical() ? kExitDone : kExitProblems;
}

} // namespace

void addTakeCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("take", "Work with a take that `record` or the window made.");
  command->require_subcommand(1);
  auto* check = command->add_subcommand(
      "check", "Track a take again and compare the result with the trajectory tracked live.");
  auto options = std::make_shared<TakeCheckOptions>();
  check->add_option("FOLDER", options->folder, "Folder of the take")->required();
  check
      ->add_option("--threads", options->threads,
                   "Number of threads of the filter; does not change the result")
      ->check(CLI::Range(1, 256));
  check->callback([options, &exitCode] { exitCode = checkTake(*options); });
}

} // namespace dewpoint::app
