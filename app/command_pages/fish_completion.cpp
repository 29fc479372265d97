// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/completions.h"

#include <fmt/format.h>

namespace dewpoint::app {
namespace {

std::string fishQuoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fishOption(const DeclaredArgument& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.valueKind.empty()) {
    text += option.choices.empty() ? " -rF" : " -xa " + fishQuoted(joined(option.choices, " "));
  }
  return text + " -d " + fishQuoted(option.description);
}

} // namespace

std::string fishCompletion(const DeclaredCommand& program) {
  const std::string& name = program.path.front();
  const std::string function = "__" + shellIdentifier(name) + "_is_at";
  std::string paths;
  for (const DeclaredCommand* command : commandAndSubcommands(program)) {
    if (command != &program) {
      paths += " " + fishQuoted(pathWithoutProgram(*command));
    }
  }
  // The command that was typed so far, compared with the function's argument.
  std::string script =
      fmt::format("# fish completion of {}, made from its declarations\n"
                  "function {}\n"
                  "    set -l known{}\n"
                  "    set -l path\n"
                  "    for word in (commandline -opc)[2..-1]\n"
                  "        if contains -- (string join -- ' ' $path $word) $known\n"
                  "            set -a path $word\n"
                  "        end\n"
                  "    end\n"
                  "    test (string join -- ' ' '' $path) = (string join -- ' ' '' $argv)\n"
                  "end\n",
                  name, function, paths);
  for (const DeclaredCommand* command : commandAndSubcommands(program)) {
    const std::string path = pathWithoutProgram(*command);
    const std::string begin =
        fmt::format("complete -c {} -n '{}{}{}'", name, function, path.empty() ? "" : " ", path);
    for (const DeclaredCommand& below : command->subcommands) {
      script +=
          fmt::format("{} -fa {} -d {}\n", begin, below.path.back(), fishQuoted(below.description));
    }
    for (const DeclaredArgument& option : command->options) {
      script += begin + fishOption(option) + "\n";
    }
  }
  return script;
}

} // namespace dewpoint::app
