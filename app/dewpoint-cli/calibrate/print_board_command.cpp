// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "core/calibration/board/board_print.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint::app {
namespace {

struct PrintOptions {
  std::string board;
  std::string paper = "A4";
  std::string out;
};

int print(const PrintOptions& options) {
  const auto board = parseBoard(options.board, "BOARD");
  const auto paper = paperNamed(options.paper);
  if (!board || !paper) {
    reportError(board ? paper.error() : board.error());
    return kExitUsage;
  }
  const auto printed = printBoard(*board, *paper, options.out);
  if (!printed) {
    Error error = printed.error();
    error.field = error.field == "paper" ? "--paper" : error.field;
    return reportError(error);
  }
  fmt::print("{}\n", options.out);
  if (const auto sheets = countSheetsToPrint(*board, *paper); sheets && *sheets > 1) {
    fmt::print("The board is larger than {}: page 1 shows how to put its {} sheets together.\n",
               paper->name, *sheets);
  }
  fmt::print("Print it at 100 % and check the scale bar with a ruler.\n");
  return kExitDone;
}

} // namespace

void addPrintBoardCommand(CLI::App& app, int& exitCode) {
  const auto present = app.get_subcommands(
      [](const CLI::App* command) { return command->get_name() == "calibration"; });
  auto* calibration = present.empty() ? nullptr : present.front();
  if (calibration == nullptr) {
    calibration = app.add_subcommand("calibration", "Work with calibration files and boards.");
    calibration->require_subcommand(1);
  }
  auto* command = calibration->add_subcommand(
      "print-board", "Write a calibration board as a PDF at its true size.");
  auto options = std::make_shared<PrintOptions>();
  command
      ->add_option("BOARD", options->board,
                   "chessboard:9x6:0.025 or charuco:7x5:0.025:0.019:DICT_4X4_50")
      ->required();
  command->add_option("OUT", options->out, "PDF to write")->required();
  command
      ->add_option("--paper", options->paper,
                   "A4, A3 or letter. A board that is larger is split on several sheets")
      ->capture_default_str();
  command->callback([options, &exitCode] { exitCode = print(*options); });
}

} // namespace dewpoint::app
