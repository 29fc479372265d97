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

/// The plots of a run, in the user's language: position, spread, sampleSize, likelihood, existence,
/// error, duration. Likelihood and existence have one curve per camera.
std::vector<PlotDeclaration> runPlots(const QStringList& cameras);
/// The same ids of a run that follows boxes in images: position and spread in pixels, the
/// similarity in place of the likelihood; there is neither existence nor error.
std::vector<PlotDeclaration> boxRunPlots();
/// Values per row of the series that these plots are drawn from.
std::size_t runPlotColumns(int cameraCount);
/// Spread of a row of such a series, all axes together: meters, of boxes pixels.
double spreadOf(const PlotSeries& series, std::size_t row, bool ofBoxes);
/// Adds one iteration to the series of its target.
void appendTo(PlotSeries& series, const IterationRecord& record);

} // namespace dewpoint::ui
