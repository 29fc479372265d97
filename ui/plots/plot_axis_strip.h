// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QWidget>

class QCPAxis;
class QCustomPlot;

namespace dewpoint::ui {

/// The numbers along the shared axis of a stack of plots, below what is scrolled: they are always
/// seen.
class PlotAxisStrip : public QWidget {
public:
  /// Both are siblings in one window; the strip is drawn again whenever the plot is.
  PlotAxisStrip(QCustomPlot& plot, QWidget* parent);

  /// The axis whose numbers these are, of the plot; null: none.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Whether the name of the axis stands at its right.
  void setNamed(bool named) { named_ = named; }
  /// The numbers as they are written.
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
