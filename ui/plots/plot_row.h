// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"
#include "ui/plots/plot_series.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Names, colors and values of the curves of one plot, beside it. Drawn on the cursor's layer, so
/// that moving the cursor draws no curve again.
class PlotReadout : public QCPLayoutElement {
public:
  PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// So wide that these plots' readouts stand in one column.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots);
  /// So high that none of them is cut off.
  static int heightFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  void setWidth(int width);
  void setValues(std::vector<double> values) { values_ = std::move(values); }
  /// "x 12 mm, y 9 mm": what is written, as a sentence.
  QString asText() const;

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
  std::vector<double> values_;
};

/// One plot of a stack: axes, curves and the readout beside them, in one row of the layout.
class PlotRow {
public:
  /// The declaration must outlive the row.
  PlotRow(QCustomPlot* plot, const PlotDeclaration& declaration, int layoutRow,
          QCPMarginGroup* margins);

  const PlotDeclaration& declaration() const { return *declaration_; }
  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* xAxis() const { return rect_->axis(QCPAxis::atBottom); }
  QCPAxis* yAxis() const { return rect_->axis(QCPAxis::atLeft); }
  PlotReadout* readout() const { return readout_; }
  /// Draws what lies in the x axis' range, and fits the y axis to it.
  void fill(const PlotSeries& series, PlotAxis axis);
  void showValues(const PlotSeries& series, std::optional<std::size_t> row);
  void applyPalette(const QPalette& palette, const QFont& font);
  /// Points of the drawn curves.
  int pointCount() const;

private:
  void fit(double least, double most);
  void prepareAxes();

  QCustomPlot* plot_;
  const PlotDeclaration* declaration_;
  QCPAxisRect* rect_;
  PlotReadout* readout_;
  std::vector<QCPGraph*> graphs_;
};

} // namespace dewpoint::ui
