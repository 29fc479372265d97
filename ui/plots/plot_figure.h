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

/// Drawn plots, as SVG or as pixels, ready to be written to a file.
struct PlotImage {
  QByteArray svg; ///< SVG; if empty, `pixels` is used
  QImage pixels;

  /// Writes SVG if there is any, otherwise PNG. Returns false on failure. May be called from any
  /// thread.
  bool save(const QString& file) const;
};

/// Draws plots as a figure for publication, with antialiased lines, named axes, and the cursor only
/// if a range or a past frame is selected. The plots have this appearance while the object exists,
/// and must be redrawn afterward.
class PlotFigure {
  Q_DECLARE_TR_FUNCTIONS(PlotFigure)
public:
  PlotFigure(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows, PlotAxis axis,
             PlotCursor& cursor);
  ~PlotFigure();
  PlotFigure(const PlotFigure&) = delete;
  PlotFigure& operator=(const PlotFigure&) = delete;

  /// Returns the figure: as SVG if `asSvg` is true, otherwise as pixels.
  PlotImage draw(bool asSvg);

private:
  void setPaintedForFigure(bool figure);

  QCustomPlot& plot_;
  const std::vector<std::unique_ptr<PlotRow>>& rows_;
  PlotAxis axis_;
  PlotCursor& cursor_;
};

} // namespace dewpoint::ui
