// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"
#include "core/experiment/report/svg_plot.h"

#include <Eigen/Core>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::experiment {

/// Style and name of each curve, as a legend lists them.
using PlotLegend = std::vector<std::pair<std::string, std::string>>;

/// The error of an experiment that was stopped.
Status experimentStopped();
/// Tells how far it is; false: stop.
bool experimentGoesOn(const ExperimentOptions& options, double part);

/// The line through values at 0, 1, 2, ... times `step`, after `first`.
SvgSeries lineOver(const std::string& style, const std::vector<double>& values, double first = 0.0,
                   double step = 1.0);
/// Points without a line: columns `across` and `up` of the rows.
SvgSeries pointsOf(const std::string& style, const Eigen::ArrayXXd& rows, Eigen::Index across,
                   Eigen::Index up, double area = 7.0);

/// Axes of one scale within which every point of all these plots lies, at least `least` meters up.
void showAll(std::initializer_list<Plot*> plots, double least = 0.5);

} // namespace dewpoint::experiment
