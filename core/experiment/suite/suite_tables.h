// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/markup.h"
#include "core/experiment/suite/suite_report.h"

#include <span>
#include <string>

namespace dewpoint::experiment {

/// Formats a number with three significant digits: "1.41", "23.4", "630", "never", "-" for no
/// value.
std::string figureText(double value);

/// HTML table of the bars of one grade, and whether each is reached.
std::string barTable(std::span<const BarResult> bars);
/// HTML table of the belief metrics of one grade, with one row per method: each metric's median
/// over the scenarios, and below it the worst scenario by name.
std::string beliefTable(std::span<const BeliefSummary> methods);
/// HTML table of median RMSE and lost frames, scenario by method.
std::string overviewTable(std::span<const SuiteCell> cells);
/// The same table with errors relative to the size of the targets: the share of frames near the
/// centroid, and the error of the radius if the methods do not know it.
std::string extentTable(std::span<const SuiteCell> cells);
/// HTML table of one scenario in one grade, with one row per method.
std::string scenarioTable(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
