// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/trajectory/csv_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace dewpoint::app {
namespace {

int showSeedBlocks() {
  fmt::print("block,first,last,what for\n");
  for (const SeedBlock& block : kSeedBlocks) {
    fmt::print("{},{},{},{}\n", block.name, block.first, block.last, csvCell(block.description));
  }
  return kExitDone;
}

} // namespace

void addSeedsCommand(CLI::App& group, int& exitCode) {
  group
      .add_subcommand(
          "seeds",
          "Print which seeds of each study are for tuning, validation and reports, as CSV.")
      ->callback([&exitCode] { exitCode = showSeedBlocks(); });
}

} // namespace dewpoint::app
