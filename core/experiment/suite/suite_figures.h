// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/svg_plot.h"
#include "core/experiment/suite/suite_summary.h"

#include <span>
#include <string>

namespace dewpoint::experiment {

/// Returns the CSS class for a method's color, which is the same in all plots: "m0" to "m7", or
/// "m8" for an unknown method.
std::string plotStyleOfMethod(const std::string& method);

/// Returns a plot of the error in each frame: the median over runs and targets, and a band from the
/// 10th to the 90th percentile. `cells` contains the methods of one scenario in one grade (level of
/// realism).
Plot errorOverTime(std::span<const SuiteCell> cells);
/// Returns a plot of the distribution of the errors: for each x, the fraction of all frames in
/// which the target is declared present with an error of at most x. Frames before convergence are
/// included. There is one curve per method in `cells`; it ends below 100 % if the method does not
/// declare the target present in some frames.
Plot errorDistribution(std::span<const SuiteCell> cells);
/// Returns a plot, for the methods in `cells`, of the fraction of estimates that are on the target
/// against the reported P(exists).
Plot reliabilityDiagram(std::span<const SuiteCell> cells);

} // namespace dewpoint::experiment
