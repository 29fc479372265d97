// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/reference/reference_pages.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace dewpoint::app {

void addReferenceCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "reference", "Print a page of the manual that is generated from the program's declarations.");
  command->group(""); // of use to script/manual only: --help does not list it
  auto page = std::make_shared<std::string>();
  command->add_option("PAGE", *page, "commands, methods or formats")
      ->required()
      ->check(CLI::IsMember({"commands", "methods", "formats"}));
  command->callback([&app, page, &exitCode] {
    fmt::print("{}", *page == "commands"  ? commandsPage(app)
                     : *page == "methods" ? methodsPage()
                                          : formatsPage());
    exitCode = kExitDone;
  });
}

} // namespace dewpoint::app
