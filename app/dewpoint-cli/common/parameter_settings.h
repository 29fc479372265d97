// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <string>
#include <vector>

namespace dewpoint::app {

/// Sets the parameters named in the texts "key=value" of --set; errors name it.
Status applySettings(const std::vector<std::string>& settings, ParameterValues& parameters);

} // namespace dewpoint::app
