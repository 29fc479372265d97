// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_bars.h"

#include <vector>

namespace dewpoint::experiment {

/// Returns the requirements that are aims for the next version. They limit the belief metrics
/// (quality of the reported confidence) in every grade (level of realism): their median over the
/// scenarios, and their value in the worst scenario. They also limit the position errors in all
/// grades except `ideal`. Their numbers continue those of the current requirements.
std::vector<SuiteRequirement> aimRequirements();

} // namespace dewpoint::experiment
