// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::experiment {

/// Style sheet of all report pages, for light and dark mode.
std::string reportStyle();

} // namespace dewpoint::experiment
