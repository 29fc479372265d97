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

/// Legend entries of a plot: the style (CSS class) and the name of each curve.
using PlotLegend = std::vector<std::pair<std::string, std::string>>;

/// Returns the error for an experiment that was stopped.
Status stoppedExperimentError();
/// Reports the progress `part` (0 to 1). Returns false if the experiment must stop.
bool reportProgress(const ExperimentOptions& options, double part);

/// Creates a line through the values, at the x positions `first` + i * `step`. `style` is the CSS
/// class of the line's color.
SvgSeries lineSeries(const std::string& style, const std::vector<double>& values,
                     double first = 0.0, double step = 1.0);
/// Creates a series of points without a line, one point per row of `rows`. Column `across` of
/// `rows` contains x, and column `up` contains y. `area` is the area of a point in square pixels,
/// and `style` the CSS class of its color.
SvgSeries pointSeries(const std::string& style, const Eigen::ArrayXXd& rows, Eigen::Index across,
                      Eigen::Index up, double area = 7.0);

/// Sets the same axis ranges on all plots, so that every point is visible. Horizontal and vertical
/// axis have the same scale. The vertical axis covers at least `least` meters.
void setCommonAxes(std::initializer_list<Plot*> plots, double least = 0.5);

} // namespace dewpoint::experiment
