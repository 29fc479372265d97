// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::ui {

class PlotRow;

/// The curves of these rows within a part of the axis, not thinned out for drawing: one line for
/// each iteration or frame, in SI units but for lengths, which are in millimeters.
std::string plotCsv(const std::vector<std::unique_ptr<PlotRow>>& rows, const PlotSeries& series,
                    PlotAxis axis, const std::pair<double, double>& range);

} // namespace dewpoint::ui
