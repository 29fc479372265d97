// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_canvas.h"

namespace dewpoint::ui {

PlotCanvas::PlotCanvas(QWidget* parent) : QCustomPlot(parent) {
  setObjectName(QStringLiteral("plotCanvas"));
  // By default, a redraw paints at once everything in the window that waits to be painted.
  setPlottingHint(QCP::phImmediateRefresh, false);
  setPlottingHint(QCP::phFastPolylines);
  connect(this, &QCustomPlot::afterReplot, this, [this] { resized_ = false; });
}

void PlotCanvas::resizeEvent(QResizeEvent* /*event*/) {
  setViewport(rect());
  resized_ = true;
  update();
}

void PlotCanvas::paintEvent(QPaintEvent* event) {
  if (resized_) {
    replot();
  }
  QCustomPlot::paintEvent(event);
}

} // namespace dewpoint::ui
