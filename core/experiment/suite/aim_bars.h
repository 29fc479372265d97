// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_bars.h"

#include <vector>

namespace dewpoint::experiment {

/// What the next version aims at: figures of belief in every grade, by the median and by the worst
/// of the scenarios, and accuracy outside grade `ideal`. The items follow those of the present
/// requirements.
std::vector<SuiteBar> aimBars();

} // namespace dewpoint::experiment
