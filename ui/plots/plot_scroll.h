// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QWidget>

class QCPAxis;
class QCustomPlot;
class QLabel;
class QScrollArea;

namespace dewpoint::ui {

class PlotAxisStrip;

/// Scroll area around a stack of plots. If there is not enough room, the plots scroll above the
/// axis numbers, which stay in place. While there are no data, a sentence covers the plots.
class PlotScroll : public QWidget {
public:
  /// Takes ownership of the plot.
  PlotScroll(QCustomPlot* plot, QWidget* parent);

  /// Sets the axis whose numbers are shown below the plots, and its quantity `kind`. If `axis` is
  /// null, no numbers are shown.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Sets whether the name of the axis is shown next to its numbers.
  void setNameShown(bool named);
  void setEmptyText(const QString& sentence);
  void setEmptyTextShown(bool isEmpty);
  /// Returns the visible part of the plot, in plot coordinates.
  QRect visibleArea() const;

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void applyPalette();

  QCustomPlot* plot_;
  QScrollArea* scroll_;
  PlotAxisStrip* strip_;
  QLabel* empty_;
};

} // namespace dewpoint::ui
