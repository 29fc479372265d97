// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::experiment {

/// Returns the style sheet for all report pages, with light and dark mode.
std::string reportStyleSheet();

} // namespace dewpoint::experiment
