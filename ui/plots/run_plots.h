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

/// Returns the declarations of the plots of a run, in the language of the window: position, spread,
/// sampleSize, likelihood, existence, error, duration. Likelihood and existence have one curve per
/// camera. Existence has an additional curve for all cameras together.
std::vector<PlotDeclaration> plotsOfRun(const QStringList& cameras);
/// Returns the declarations of the plots of a run that tracks bounding boxes. The ids are those of
/// plotsOfRun(), without existence and error. Position and spread are in pixels, and the similarity
/// replaces the likelihood.
std::vector<PlotDeclaration> plotsOfBoxRun();
/// Returns the number of values per row in the series from which the plots of a run are drawn.
std::size_t columnCountOfRunPlots(int cameraCount);
/// Returns the particle spread in a row of the series of a run's plots, combined over all axes, in
/// meters, or in pixels for bounding boxes.
double particleSpreadOf(const PlotSeries& series, std::size_t row);
/// Appends the values of one filter iteration of a target as a row to the series from which the
/// plots of this target are drawn.
void appendIteration(PlotSeries& series, const IterationRecord& record);

} // namespace dewpoint::ui
