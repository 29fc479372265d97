// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QWidget>

class QCPAxis;
class QCustomPlot;

namespace dewpoint::ui {

/// Strip with the axis numbers shared by a stack of plots. The strip is below the scroll area of
/// the plots, so it is always visible.
class PlotAxisStrip : public QWidget {
public:
  /// Creates the strip as a sibling of the plot. It is redrawn whenever the plot is redrawn.
  PlotAxisStrip(QCustomPlot& plot, QWidget* parent);

  /// Sets the plot axis whose numbers are drawn, and its quantity `kind`. If `axis` is null, no
  /// numbers are drawn.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Sets whether the axis name is drawn at the right end.
  void setNameShown(bool named) { nameShown_ = named; }
  /// Returns the axis numbers as drawn.
  QStringList tickLabels() const;

  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QFont numberFont() const;

  QCustomPlot& plot_;
  QCPAxis* axis_ = nullptr;
  PlotAxis kind_ = PlotAxis::Iterations;
  bool nameShown_ = true;
};

} // namespace dewpoint::ui
