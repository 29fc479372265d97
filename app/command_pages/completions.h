// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

// Scripts that complete the command line of a program in a shell: commands, options, and the
// choices of an option; files where there are no choices. None of them starts the program.

/// For bash; needs nothing of the package bash-completion, which only finds it.
std::string bashCompletion(const DeclaredCommand& program);

/// For zsh: the file _PROGRAM of a folder of its fpath.
std::string zshCompletion(const DeclaredCommand& program);

/// For fish.
std::string fishCompletion(const DeclaredCommand& program);

} // namespace dewpoint::app
