// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::ui {

class PlotRow;

/// Returns the curves of these plots within an axis range as CSV, one line per iteration or frame,
/// with all data points. Values have the units of the plots' axes (valueInAxisUnit()), which the
/// column names contain: for example, positions are in meters, spreads and errors in millimeters,
/// durations in microseconds.
std::string plotCsv(const std::vector<std::unique_ptr<PlotRow>>& rows, const PlotSeries& series,
                    PlotAxis axis, const std::pair<double, double>& range);

} // namespace dewpoint::ui
