// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/markup.h"
#include "core/experiment/suite/suite_report.h"

#include <span>
#include <string>

namespace dewpoint::experiment {

/// Formats a number with about three significant digits, such as "1.41", "23.4" or "630". Infinity
/// becomes "never", and a missing value becomes "-".
std::string formatValue(double value);

/// Returns an HTML table of the requirements of one grade, showing whether each is met.
std::string requirementTable(std::span<const RequirementResult> requirements);
/// Returns an HTML table of the belief metrics of one grade, with one row per method. Each cell
/// contains the metric's median over the scenarios, and below it the value and name of the worst
/// scenario.
std::string beliefTable(std::span<const BeliefSummary> methods);
/// Returns an HTML table of median RMSE and lost frames, with one row per scenario and one column
/// per method.
std::string overviewTable(std::span<const SuiteCell> cells);
/// Returns an HTML table of errors relative to the target size, with one row per scenario and one
/// column per method: the fraction of frames with an estimate near the centroid, and the radius
/// error if the methods do not know the radius.
std::string extentTable(std::span<const SuiteCell> cells);
/// Returns an HTML table of the metrics of one scenario in one grade, with one row per method.
std::string scenarioTable(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
