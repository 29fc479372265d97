// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_readout.h"
#include "ui/plots/plot_series.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// One plot in a stack, in one row of the layout: its title, axes, curves and readout.
class PlotRow {
public:
  /// Maximum number of points up to which a curve also shows dots, so that a run that has just
  /// begun is visible.
  static constexpr int kMaxDots = 29;

  /// Creates the plot. The declaration must outlive this object.
  PlotRow(QCustomPlot* plot, const PlotDeclaration& declaration, int layoutRow,
          QCPMarginGroup* margins);

  const PlotDeclaration& declaration() const { return *declaration_; }
  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* xAxis() const { return rect_->axis(QCPAxis::atBottom); }
  QCPAxis* yAxis() const { return rect_->axis(QCPAxis::atLeft); }
  PlotCaption* caption() const { return caption_; }
  PlotReadout* readout() const { return readout_; }
  /// Empty space above and below the axes, pixels.
  static constexpr int kGapPx = 4;

  /// Returns the minimum height (pixels) at which the title, readout and two axis numbers are
  /// readable.
  int minimumHeightFor(const QFont& font) const;
  /// Returns the weight with which the row shares the total height with other rows.
  double heightWeight() const;
  /// Draws the data within the range of the x axis, and adjusts the y axis to the data.
  void fill(const PlotSeries& series, PlotAxis axis);
  void showValues(const PlotSeries& series, std::optional<std::size_t> row);
  /// Returns the title and the values of a row of the series as text: "Spread: x 12 mm, y 9 mm".
  QString valuesText(const PlotSeries& series, std::optional<std::size_t> row) const;
  void applyPalette(const QPalette& palette, const QFont& font);
  /// Sets whether lines are drawn as in a figure for publication, starting with the next `fill()`.
  void setDrawnForFigure(bool figure);
  /// Returns the number of points in the drawn curves.
  int pointCount() const;
  /// Returns whether any curve shows dots.
  bool hasDots() const;

private:
  std::vector<double> valuesOf(const PlotSeries& series, std::optional<std::size_t> row) const;
  /// Graphs of one curve; null for a graph that the curve does not have.
  struct CurveGraphs {
    QCPGraph* curve = nullptr;
    QCPGraph* lowerBandEdge = nullptr;
    QCPGraph* upperBandEdge = nullptr;
    QCPGraph* truthCurve = nullptr;
  };
  /// Minimum and maximum drawn values.
  struct Extremes {
    Extremes();
    void extendBy(const Extremes& other);
    bool hasValues() const { return minimum <= maximum; }

    double minimum;
    double maximum;
    int pointCount = 0;
  };
  QCPGraph* addGraph(const QString& name);
  void addGraphs();
  Extremes draw(QCPGraph* graph, const PlotSeries& series, PlotAxis axis, std::size_t column,
                const std::optional<PlotSeries::ColumnOffset>& offset = std::nullopt) const;
  void fit(const Extremes& values, const Extremes& bands);
  void prepareAxes();
  void updateMaxTicks();

  QCustomPlot* plot_;
  const PlotDeclaration* declaration_;
  PlotCaption* caption_;
  QCPAxisRect* rect_;
  PlotReadout* readout_;
  std::vector<CurveGraphs> graphs_; ///< in the order of the declared curves
};

} // namespace dewpoint::ui
