// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QString>

#include <memory>
#include <vector>

class QCustomPlot;

namespace dewpoint::ui {

class PlotCursor;
class PlotRow;

/// Plots as they were drawn, for a file.
struct PlotPicture {
  QByteArray drawing; ///< SVG; empty: the pixels count
  QImage pixels;

  /// Writes it: as SVG, or else as PNG. False when that cannot be. Any thread.
  bool save(const QString& file) const;
};

/// Plots as a figure for paper: smooth lines, named axes, and no cursor without need. While it
/// exists the plots are drawn so; afterwards they have to be drawn again.
class PlotFigure {
  Q_DECLARE_TR_FUNCTIONS(PlotFigure)
public:
  PlotFigure(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows, PlotAxis axis,
             PlotCursor& cursor);
  ~PlotFigure();
  PlotFigure(const PlotFigure&) = delete;
  PlotFigure& operator=(const PlotFigure&) = delete;

  /// The figure as it is now, as a drawing (SVG) or as pixels.
  PlotPicture draw(bool asDrawing);

private:
  void paintFor(bool figure);

  QCustomPlot& plot_;
  const std::vector<std::unique_ptr<PlotRow>>& rows_;
  PlotAxis axis_;
  PlotCursor& cursor_;
};

} // namespace dewpoint::ui
