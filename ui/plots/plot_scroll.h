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

/// Frame around the plots of a stack. Without enough room the plots scroll above the axis numbers,
/// which stay in place. Without data, a sentence covers the plots.
class PlotScroll : public QWidget {
public:
  /// Takes ownership of the plot.
  PlotScroll(QCustomPlot* plot, QWidget* parent);

  /// Sets the axis whose numbers are shown below; null: none.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Sets whether the name of that axis is shown as well.
  void setNamed(bool named);
  void setEmptyText(const QString& sentence);
  void showEmpty(bool isEmpty);
  /// Visible part of the plot, in its coordinates.
  QRect sight() const;

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
