// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"
#include "ui/plots/plot_series.h"

#include <QStringList>

#include <vector>

namespace dewpoint::session {
struct IterationRecord;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Returns the plots of a run, translated: position, spread, sampleSize, likelihood, existence,
/// error, duration. Likelihood and existence have one curve per camera; existence has one more for
/// all cameras together.
std::vector<PlotDeclaration> runPlots(const QStringList& cameras);
/// Returns the plots, with the same ids, of a run that tracks bounding boxes: position and spread
/// are in pixels, the similarity replaces the likelihood, and there is neither existence nor error.
std::vector<PlotDeclaration> boxRunPlots();
/// Number of values per row of the series that these plots are drawn from.
std::size_t runPlotColumns(int cameraCount);
/// Spread of a row of such a series, all axes together: meters, of boxes pixels.
double spreadOf(const PlotSeries& series, std::size_t row);
/// Adds one iteration to the series of its target.
void appendTo(PlotSeries& series, const IterationRecord& record);

} // namespace dewpoint::ui
