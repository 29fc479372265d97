// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/completions.h"

#include <fmt/format.h>

namespace dewpoint::app {
namespace {

/// The path as the script builds it: "" for the program, " calibration convert".
std::string bashPath(const DeclaredCommand& command) {
  const std::string path = pathWithoutProgram(command);
  return path.empty() ? path : " " + path;
}

std::string knownPaths(const DeclaredCommand& program) {
  std::vector<std::string> paths;
  for (const DeclaredCommand* command : commandAndSubcommands(program)) {
    if (command != &program) {
      paths.push_back(singleQuoted(bashPath(*command)));
    }
  }
  return joined(paths, " | \\\n      ");
}

/// One case for every option that takes a value.
std::string valuesOf(const DeclaredCommand& command) {
  std::string cases;
  for (const DeclaredArgument& option : command.options) {
    if (option.valueKind.empty()) {
      continue;
    }
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      patterns.push_back(singleQuoted(bashPath(command) + " " + name));
    }
    cases += fmt::format("  {}) words={}; value=1 ;;\n", joined(patterns, " | "),
                         singleQuoted(joined(option.choices, " ")));
  }
  return cases;
}

} // namespace

std::string bashCompletion(const DeclaredCommand& program) {
  const std::string& name = program.path.front();
  const std::string function = "_" + shellIdentifier(name);
  std::string script = fmt::format("# bash completion of {}, made from its declarations\n{}() {{\n"
                                   "  local path='' words='' value='' word k\n"
                                   "  local current=${{COMP_WORDS[COMP_CWORD]}}\n"
                                   "  local previous=${{COMP_WORDS[COMP_CWORD - 1]}}\n"
                                   "  COMPREPLY=()\n",
                                   name, function);
  // bash takes the = of --option=value for a word of its own.
  script += "  if [[ $current == '=' ]]; then\n    current=''\n"
            "  elif [[ $previous == '=' ]]; then\n"
            "    previous=${COMP_WORDS[COMP_CWORD - 2]}\n  fi\n";
  if (!program.subcommands.empty()) {
    script += fmt::format("  for ((k = 1; k < COMP_CWORD; ++k)); do\n"
                          "    word=${{COMP_WORDS[k]}}\n"
                          "    case \"$path $word\" in\n    {}) path+=\" $word\" ;;\n    esac\n"
                          "  done\n",
                          knownPaths(program));
  }
  std::string values;
  std::string names;
  for (const DeclaredCommand* command : commandAndSubcommands(program)) {
    values += valuesOf(*command);
    names += fmt::format("    {}) words={} ;;\n", singleQuoted(bashPath(*command)),
                         singleQuoted(joined(optionNames(*command), " ")));
  }
  script += fmt::format("  case \"$path $previous\" in\n{}  *) ;;\n  esac\n", values);
  script += fmt::format("  if [[ -z $value && $current == -* ]]; then\n"
                        "    case \"$path\" in\n{}    esac\n",
                        names);
  if (!program.subcommands.empty()) {
    std::string commands;
    for (const DeclaredCommand* command : commandAndSubcommands(program)) {
      if (!command->subcommands.empty()) {
        commands += fmt::format("    {}) words={} ;;\n", singleQuoted(bashPath(*command)),
                                singleQuoted(joined(commandNames(*command), " ")));
      }
    }
    script +=
        fmt::format("  elif [[ -z $value ]]; then\n    case \"$path\" in\n{}    esac\n", commands);
  }
  return script + fmt::format("  fi\n"
                              "  [[ -n $words ]] && COMPREPLY=($(compgen -W \"$words\" -- "
                              "\"$current\"))\n"
                              "  return 0\n}}\n"
                              "complete -o default -F {} {}\n",
                              function, name);
}

} // namespace dewpoint::app
