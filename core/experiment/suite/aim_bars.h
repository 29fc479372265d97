// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_bars.h"

#include <vector>

namespace dewpoint::experiment {

/// Returns the aims for the next version: belief metrics in every grade, by the median and by the
/// worst scenario, and accuracy outside grade `ideal`. Their item numbers continue the numbering of
/// the current requirements.
std::vector<SuiteRequirement> aimRequirements();

} // namespace dewpoint::experiment
