// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

#include <string>

namespace dewpoint::app {

// Pages of the manual in Markdown, made from the declarations that the program itself works with.

/// Every command below `app` with its arguments and options.
std::string commandsPage(const CLI::App& app);

/// The methods by their use, each with its parameters.
std::string methodsPage();

/// The formats that trajectories and calibrations are written in.
std::string formatsPage();

} // namespace dewpoint::app
