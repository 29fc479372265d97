// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/markup.h"
#include "core/experiment/suite/suite_report.h"

#include <span>
#include <string>

namespace dewpoint::experiment {

/// Three significant digits as people read them: "1.41", "23.4", "630", "never", "-" for nothing.
std::string figureText(double value);

/// The bars of one grade, and whether each is reached, as an HTML table.
std::string barTable(std::span<const BarResult> bars);
/// What the methods believe in one grade: a row per method; each figure's median over the
/// scenarios, and below it the worst scenario by name.
std::string beliefTable(std::span<const BeliefSummary> methods);
/// Median RMSE and lost frames, scenario by method.
std::string overviewTable(std::span<const SuiteCell> cells);
/// The same, relative to the size of the targets: the share of frames near the centroid, and the
/// error of the radius where the methods are not told it.
std::string extentTable(std::span<const SuiteCell> cells);
/// One scenario in one grade: a row per method.
std::string scenarioTable(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
