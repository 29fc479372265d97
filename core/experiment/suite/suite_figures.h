// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/svg_plot.h"
#include "core/experiment/suite/suite_summary.h"

#include <span>
#include <string>

namespace dewpoint::experiment {

/// CSS class of a method's color, the same in all plots: "m0" to "m7"; "m8" for one that is not
/// known.
std::string methodStyle(const std::string& method);

/// The three plots of a scenario; `cells` are its methods.
/// Median error and the band from the 10th to the 90th percentile over runs and targets, by frame.
Plot errorOverTime(std::span<const SuiteCell> cells);
/// Share of all frames from the start in which the target is declared with an error of at most x:
/// the curve ends below 100 % where a method declares nothing.
Plot errorDistribution(std::span<const SuiteCell> cells);
/// How often the target was where the estimate stated, over the stated P(exists).
Plot reliabilityDiagram(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
