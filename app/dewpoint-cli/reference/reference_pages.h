// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>

namespace dewpoint::app {

// Pages of the manual in Markdown, generated from the declarations that the program itself uses.

/// Describes every command below `app` with its arguments and options.
std::string commandsPage(const CLI::App& app);

/// Lists the methods by their use, each with its parameters.
std::string methodsPage();

/// Lists the formats for trajectories and calibrations.
std::string formatsPage();

} // namespace dewpoint::app
