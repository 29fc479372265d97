// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <qcustomplot.h>

#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Vertical lines and a selected range drawn across all plots in a stack. They are drawn on a
/// separate layer, so that moving them does not redraw the curves. Positions are in units of the
/// shared axis.
class PlotCursor : public QCPLayerable {
public:
  PlotCursor(QCustomPlot* plot, const QString& layer) : QCPLayerable(plot, layer) {}

  std::vector<QCPAxisRect*> axisRects; ///< plots that the lines cross
  std::optional<double> currentPosition;
  std::optional<double> hoveredPosition;
  std::optional<std::pair<double, double>> selectedRange;
  std::optional<std::pair<double, double>>
      draggedRange; ///< range to zoom to, while it is being dragged

protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
};

} // namespace dewpoint::ui
