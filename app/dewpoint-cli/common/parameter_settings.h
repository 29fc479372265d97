// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <string>
#include <vector>

namespace dewpoint::app {

/// Sets the parameters given as "key=value" strings with the option --set. Returns an error that
/// names this option if a string is invalid.
Status applySettings(const std::vector<std::string>& settings, ParameterValues& parameters);

} // namespace dewpoint::app
