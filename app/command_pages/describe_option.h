// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>

namespace dewpoint::app {

/// Adds the option --describe (man, bash, zsh, fish), which is hidden from --help. The option
/// prints the manual page or a shell completion script for everything declared in `app`, and ends
/// the program. The build uses this option to create the installed files. `seeAlso` is the name of
/// another program to which the manual page refers.
void addDescribeOption(CLI::App& app, const std::string& seeAlso);

} // namespace dewpoint::app
