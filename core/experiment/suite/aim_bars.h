// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_bars.h"

#include <vector>

namespace dewpoint::experiment {

/// Aims of the next version: metrics of belief in every grade, by the median and by the worst of
/// the scenarios, and accuracy outside grade `ideal`. The item numbers follow those of the current
/// requirements.
std::vector<SuiteBar> aimBars();

} // namespace dewpoint::experiment
