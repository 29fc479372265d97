// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace dewpoint::app {

/// Option or positional argument of a command, as declared for the command line.
struct DeclaredArgument {
  std::vector<std::string> names; ///< "-h", "--help"; a positional argument has only its name
  std::string valueKind;          ///< kind of value, such as TEXT; empty for a flag
  std::vector<std::string> choices;
  std::string range; ///< range of allowed values if they are not a list, such as "INT in [1 - 256]"
  std::string defaultValue;
  std::string description;
  bool isRequired = false;
  bool isRepeatable = false;
};

/// Command of a program with all its subcommands, as declared for the command line. Parts hidden
/// from --help are omitted.
struct DeclaredCommand {
  /// Names from the program to this command, for example {"dewpoint-cli", "calibration",
  /// "convert"}.
  std::vector<std::string> path;
  std::string description;
  std::string footer;
  std::vector<DeclaredArgument> options;
  std::vector<DeclaredArgument> positionals;
  std::vector<DeclaredCommand> subcommands;
};

/// Returns the commands, options and arguments declared in `app`.
DeclaredCommand declaredCommand(const CLI::App& app);

/// Returns the command and all its subcommands; each command comes before its own subcommands.
std::vector<const DeclaredCommand*> commandAndSubcommands(const DeclaredCommand& command);

/// Joins strings with `separator` between them.
std::string joined(const std::vector<std::string>& texts, const std::string& separator);

/// Returns the path without the program name, such as "calibration convert"; empty for the program
/// itself.
std::string pathWithoutProgram(const DeclaredCommand& command);

/// Returns the names of all options of a command.
std::vector<std::string> optionNames(const DeclaredCommand& command);

/// Returns the names of the direct subcommands of a command.
std::vector<std::string> commandNames(const DeclaredCommand& command);

/// Returns a name for a shell function: every character except letters and digits becomes an
/// underscore.
std::string shellIdentifier(const std::string& text);

/// Returns the text with every occurrence of `what` replaced by `by`.
std::string replaced(std::string text, const std::string& what, const std::string& by);

/// Returns the text as one word for a POSIX shell, in single quotes.
std::string singleQuoted(const std::string& text);

} // namespace dewpoint::app
