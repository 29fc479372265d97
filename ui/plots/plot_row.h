// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_readout.h"
#include "ui/plots/plot_series.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// One plot of a stack: its title, axes, curves and the readout beside them, in one row of the
/// layout.
class PlotRow {
public:
  /// Up to so many points of a curve are drawn as dots, too: a run that has just begun is seen.
  static constexpr int kMostDots = 29;

  /// The declaration must outlive the row.
  PlotRow(QCustomPlot* plot, const PlotDeclaration& declaration, int layoutRow,
          QCPMarginGroup* margins);

  const PlotDeclaration& declaration() const { return *declaration_; }
  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* xAxis() const { return rect_->axis(QCPAxis::atBottom); }
  QCPAxis* yAxis() const { return rect_->axis(QCPAxis::atLeft); }
  PlotCaption* caption() const { return caption_; }
  PlotReadout* readout() const { return readout_; }
  /// The height in which title, readout and two numbers of the axis can be read.
  int leastHeight(const QFont& font) const;
  /// Its share of the height, compared with other rows.
  double heightShare() const;
  /// Draws what lies in the x axis' range, and fits the y axis to it.
  void fill(const PlotSeries& series, PlotAxis axis);
  void showValues(const PlotSeries& series, std::optional<std::size_t> row);
  void applyPalette(const QPalette& palette, const QFont& font);
  /// Lines as a figure on paper has them, or as the window has them from the next fill() on.
  void drawForFigure(bool figure);
  /// Points of the drawn curves.
  int pointCount() const;
  /// Whether dots are drawn on any curve.
  bool hasDots() const;

private:
  /// What is drawn of one curve; what it does not have is null.
  struct Drawn {
    QCPGraph* curve = nullptr;
    QCPGraph* bandLower = nullptr;
    QCPGraph* bandUpper = nullptr;
    QCPGraph* truth = nullptr;
  };
  /// Least and greatest value of what was drawn.
  struct Extremes {
    Extremes();
    void add(const Extremes& other);
    bool any() const { return least <= most; }

    double least;
    double most;
    int points = 0;
  };
  QCPGraph* addGraph(const QString& name);
  void addGraphs();
  Extremes draw(QCPGraph* graph, const PlotSeries& series, PlotAxis axis, std::size_t column,
                const std::optional<PlotSeries::Offset>& offset = std::nullopt) const;
  void fit(const Extremes& values, const Extremes& bands);
  void prepareAxes();
  void setMostTicks();

  QCustomPlot* plot_;
  const PlotDeclaration* declaration_;
  PlotCaption* caption_;
  QCPAxisRect* rect_;
  PlotReadout* readout_;
  std::vector<Drawn> drawn_; ///< as the curves of the declaration
};

} // namespace dewpoint::ui
