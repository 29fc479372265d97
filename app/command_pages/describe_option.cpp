// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/describe_option.h"

#include "app/command_pages/completions.h"
#include "app/command_pages/man_page.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <map>

namespace dewpoint::app {

void addDescribeOption(CLI::App& app, const std::string& seeAlso) {
  using Writer = std::function<std::string(const DeclaredCommand&)>;
  const std::map<std::string, Writer> writers{{"man",
                                               [seeAlso](const DeclaredCommand& program) {
                                                 return manPage(program, DEWPOINT_VERSION, seeAlso);
                                               }},
                                              {"bash", bashCompletion},
                                              {"zsh", zshCompletion},
                                              {"fish", fishCompletion}};
  const auto write = [&app, writers](const std::string& format) {
    if (const auto writer = writers.find(format); writer != writers.end()) {
      fmt::print("{}", writer->second(declaredCommand(app)));
      throw CLI::Success();
    }
    throw CLI::ValidationError("--describe", "expected man, bash, zsh or fish, not " + format);
  };
  app.add_option_function<std::string>(
         "--describe", write, "Print the manual page or a completion: man, bash, zsh, fish")
      ->trigger_on_parse()
      ->group("");
}

} // namespace dewpoint::app
