// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::experiment {

/// The style sheet of every report's page, light and dark.
std::string reportStyle();

} // namespace dewpoint::experiment
