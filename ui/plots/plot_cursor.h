// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <qcustomplot.h>

#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Lines and a range across all plots of a stack, on a layer of their own: they move without any
/// curve being drawn again. Positions are those of the shared axis.
class PlotCursor : public QCPLayerable {
public:
  PlotCursor(QCustomPlot* plot, const QString& layer) : QCPLayerable(plot, layer) {}

  std::vector<QCPAxisRect*> rects; ///< those it crosses
  std::optional<double> currentFrame;
  std::optional<double> hovered;
  std::optional<std::pair<double, double>> selectedRange;
  std::optional<std::pair<double, double>> dragged; ///< part to be zoomed to

protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
};

} // namespace dewpoint::ui
