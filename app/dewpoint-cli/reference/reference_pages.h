// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>

namespace dewpoint::app {

// Pages of the manual in Markdown, generated from the declarations that the program itself uses.

/// Returns the page that describes every command below `app` with its arguments and options.
std::string commandsPage(const CLI::App& app);

/// Returns the page that lists the methods by their use, each with its parameters.
std::string methodsPage();

/// Returns the page that lists the file formats for trajectories and calibrations.
std::string formatsPage();

} // namespace dewpoint::app
