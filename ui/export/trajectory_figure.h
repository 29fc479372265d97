// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_table.h"
#include "core/trajectory/figure/figure_drawing.h"

#include <filesystem>

class QPainter;
class QRectF;

namespace dewpoint::ui {

/// Draws the figure of a trajectory (`layOutFigure()`) into a rectangle of a page, in the target
/// colors, dark on white.
void drawTrajectoryFigure(QPainter& painter, const QRectF& page, const ExportTable& table,
                          const FigureTexts& texts);

/// Writes the figure of a trajectory to a file, as SVG or PDF (A4, landscape) depending on the
/// suffix. The file is written under a temporary name and then renamed, so it is never incomplete.
/// May be called from any thread.
Status writeTrajectoryFigure(const ExportTable& table, const FigureTexts& texts,
                             const std::filesystem::path& file);

} // namespace dewpoint::ui
