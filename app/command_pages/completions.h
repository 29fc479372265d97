// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

// Shell scripts that complete the command line of a program: commands, options, the choices of an
// option, and file names where there are no choices. None of the scripts starts the program.

/// Returns the script for bash. The script calls no functions of the bash-completion package; that
/// package is only needed to find and load the script automatically.
std::string bashCompletion(const DeclaredCommand& program);

/// Returns the script for zsh: the content of a file named _PROGRAM in a folder on the fpath.
std::string zshCompletion(const DeclaredCommand& program);

/// Returns the script for fish.
std::string fishCompletion(const DeclaredCommand& program);

} // namespace dewpoint::app
