// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace dewpoint::app {

/// An option or a positional argument as it was declared.
struct DeclaredArgument {
  std::vector<std::string> names; ///< "-h", "--help"; of a positional argument its name alone
  std::string value;              ///< kind of its value, as TEXT; empty for a flag
  std::vector<std::string> choices;
  std::string range; ///< what is allowed, where that is no list, as "INT in [1 - 256]"
  std::string fallback;
  std::string sentence;
  bool isRequired = false;
  bool repeats = false;
};

/// A command with everything below it. What is hidden from --help is left out.
struct DeclaredCommand {
  /// Names from the program's on: {"dewpoint-cli", "calibration", "convert"}.
  std::vector<std::string> path;
  std::string sentence;
  std::string footer;
  std::vector<DeclaredArgument> options;
  std::vector<DeclaredArgument> positionals;
  std::vector<DeclaredCommand> commands;
};

/// Reads a declared command line.
DeclaredCommand declaredCommand(const CLI::App& app);

/// The command and all below it, each before those below it.
std::vector<const DeclaredCommand*> withAllBelow(const DeclaredCommand& command);

/// Texts one after the other, with `separator` between them.
std::string joined(const std::vector<std::string>& texts, const std::string& separator);

/// The path without the program's name, as "calibration convert"; empty for the program.
std::string pathBelowProgram(const DeclaredCommand& command);

/// All names of the options of a command.
std::vector<std::string> optionNames(const DeclaredCommand& command);

/// The names of the commands directly below a command.
std::vector<std::string> commandNames(const DeclaredCommand& command);

/// A name for a function of a shell: every character but letters and digits is an underscore.
std::string shellIdentifier(const std::string& text);

/// The text with every occurrence of `what` replaced.
std::string replaced(std::string text, const std::string& what, const std::string& by);

/// The text as one word of a POSIX shell, in single quotes.
std::string singleQuoted(const std::string& text);

} // namespace dewpoint::app
