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

/// Style and name of each curve, as listed in a legend.
using PlotLegend = std::vector<std::pair<std::string, std::string>>;

/// Error of an experiment that was stopped.
Status experimentStopped();
/// Reports the progress `part` (0 to 1). Returns false if the experiment must stop.
bool experimentGoesOn(const ExperimentOptions& options, double part);

/// Line through values at `first` plus 0, 1, 2, ... times `step`.
SvgSeries lineOver(const std::string& style, const std::vector<double>& values, double first = 0.0,
                   double step = 1.0);
/// Points without a line, from the columns `across` and `up` of the rows. `area` is in square
/// pixels.
SvgSeries pointsOf(const std::string& style, const Eigen::ArrayXXd& rows, Eigen::Index across,
                   Eigen::Index up, double area = 7.0);

/// Gives all these plots the same axes, with one scale for both directions, so that every point is
/// visible. They cover at least `least` meters vertically.
void showAll(std::initializer_list<Plot*> plots, double least = 0.5);

} // namespace dewpoint::experiment
