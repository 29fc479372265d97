// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

// Shell scripts that complete the command line of a program: its commands, options, the choices of
// an option, and otherwise file names. The scripts never start the program.

/// Returns the completion script for bash. The script works without the bash-completion package,
/// which is only needed to find and load the script automatically.
std::string bashCompletion(const DeclaredCommand& program);

/// Returns the completion script for zsh: the content of a file named _PROGRAM in a folder on the
/// fpath.
std::string zshCompletion(const DeclaredCommand& program);

/// Returns the completion script for fish.
std::string fishCompletion(const DeclaredCommand& program);

} // namespace dewpoint::app
