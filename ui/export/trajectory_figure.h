// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export_table.h"

#include <QString>

#include <filesystem>

class QPainter;
class QRectF;

namespace dewpoint::ui {

/// Words of a figure, in the person's language.
struct FigureWords {
  QString title;
  QString time; ///< "time (s)"
  QString topView;
};

/// Draws a trajectory for print: x, y and z over time with a band of two standard deviations, the
/// path from above beside them, a legend. Colors of the targets, dark on white.
void drawTrajectoryFigure(QPainter& painter, const QRectF& page, const ExportTable& table,
                          const FigureWords& words);

/// Writes the figure as SVG or, by the suffix, PDF (A4, landscape); beside, and renamed. Any
/// thread.
Status writeTrajectoryFigure(const ExportTable& table, const FigureWords& words,
                             const std::filesystem::path& file);

} // namespace dewpoint::ui
