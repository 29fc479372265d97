// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>

namespace dewpoint::app {

/// Adds the option --describe, which is not listed by --help: it prints the manual page or a
/// shell's completion of everything that is declared in `app` (man, bash, zsh, fish), and ends the
/// program. The build makes the installed files with it. `seeAlso`: the other program.
void addDescribeOption(CLI::App& app, const std::string& seeAlso);

} // namespace dewpoint::app
