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

/// What is around the plots of a stack: in little room they are scrolled, above the numbers of the
/// axis, which stay; without data a sentence covers them.
class PlotScroll : public QWidget {
public:
  /// Takes the plot.
  PlotScroll(QCustomPlot* plot, QWidget* parent);

  /// The axis whose numbers stand below; null: none.
  void setAxis(QCPAxis* axis, PlotAxis kind);
  /// Whether the name of the axis stands there, too.
  void setNamed(bool named);
  void setEmptyText(const QString& sentence);
  void showEmpty(bool isEmpty);
  /// The part of the plot that is seen, in its coordinates.
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
