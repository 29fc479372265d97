// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QWidget>

class QCPAxis;
class QCustomPlot;

namespace dewpoint::ui {

/// Numbers of the shared axis of a stack of plots. The strip lies below the scrolled plots, so it
/// is always visible.
class PlotAxisStrip : public QWidget {
public:
  /// Creates the strip as a sibling of the plot; it is redrawn with every redraw of the plot.
  PlotAxisStrip(QCustomPlot& plot, QWidget* parent);

  /// Sets the axis of the plot whose numbers are drawn; null: none.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Sets whether the name of the axis is drawn at its right end.
  void setNamed(bool named) { named_ = named; }
  /// Texts of the numbers as drawn.
  QStringList labels() const;

  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QFont numberFont() const;

  QCustomPlot& plot_;
  QCPAxis* axis_ = nullptr;
  PlotAxis kind_ = PlotAxis::Iterations;
  bool named_ = true;
};

} // namespace dewpoint::ui
