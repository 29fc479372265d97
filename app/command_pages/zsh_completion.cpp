// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/completions.h"

#include <fmt/format.h>

namespace dewpoint::app {
namespace {

std::string functionOf(const DeclaredCommand& command) {
  return "_" + joined(command.path, "_");
}

/// A sentence within the brackets or quotes of a specification of _arguments.
std::string zshText(const std::string& text) {
  std::string escaped = replaced(text, "\\", "\\\\");
  for (const char* special : {"[", "]", ":"}) {
    escaped = replaced(escaped, special, std::string("\\") + special);
  }
  return escaped;
}

/// ":TEXT:_files" or ":TEXT:(one other)".
std::string zshValue(const DeclaredArgument& argument, const std::string& label) {
  const std::string action =
      argument.choices.empty() ? "_files" : "(" + joined(argument.choices, " ") + ")";
  return ":" + zshText(label) + ":" + action;
}

std::string zshOptions(const DeclaredCommand& command) {
  std::string lines;
  for (const DeclaredArgument& option : command.options) {
    for (const std::string& name : option.names) {
      std::string specification = option.isRepeatable ? "*" : "(" + joined(option.names, " ") + ")";
      specification += name + "[" + zshText(option.description) + "]";
      if (!option.valueKind.empty()) {
        specification += zshValue(option, option.valueKind);
      }
      lines += " \\\n    " + singleQuoted(specification);
    }
  }
  return lines;
}

std::string zshPositionals(const DeclaredCommand& command) {
  std::string lines;
  int place = 1;
  for (const DeclaredArgument& positional : command.positionals) {
    const std::string where = positional.isRepeatable ? "*" : std::to_string(place++);
    lines += " \\\n    " + singleQuoted(where + zshValue(positional, positional.names.front()));
  }
  return lines;
}

std::string zshFunction(const DeclaredCommand& command) {
  std::string text = fmt::format("{}() {{\n", functionOf(command));
  if (command.subcommands.empty()) {
    return text +
           fmt::format("  _arguments{}{}\n}}\n", zshOptions(command), zshPositionals(command));
  }
  text += "  local context state state_descr line\n  local -a commands\n  typeset -A opt_args\n"
          "  commands=(\n";
  std::string cases;
  for (const DeclaredCommand& below : command.subcommands) {
    text += "    " + singleQuoted(below.path.back() + ":" + zshText(below.description)) + "\n";
    cases += fmt::format("      {}) {} ;;\n", below.path.back(), functionOf(below));
  }
  return text + fmt::format("  )\n  _arguments -C{} \\\n    '1: :->command' '*:: :->rest'\n"
                            "  case $state in\n"
                            "  command) _describe command commands ;;\n"
                            "  rest)\n    case $words[1] in\n{}    esac\n    ;;\n  esac\n}}\n",
                            zshOptions(command), cases);
}

} // namespace

std::string zshCompletion(const DeclaredCommand& program) {
  const std::string& name = program.path.front();
  std::string script =
      fmt::format("#compdef {}\n# Made from the declarations of {}.\n", name, name);
  for (const DeclaredCommand* command : commandAndSubcommands(program)) {
    script += zshFunction(*command);
  }
  // Found by its name the first time, or read into a running shell.
  return script + fmt::format("if [[ $funcstack[1] == {0} ]]; then\n  {0} \"$@\"\nelse\n"
                              "  compdef {0} {1}\nfi\n",
                              functionOf(program), name);
}

} // namespace dewpoint::app
