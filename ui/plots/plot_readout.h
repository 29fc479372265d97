// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"

#include <qcustomplot.h>

#include <vector>

namespace dewpoint::ui {

/// Title of one plot with its unit, in up to two lines to the left of the axis numbers.
class PlotCaption : public QCPLayoutElement {
public:
  PlotCaption(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// Returns the width in pixels in which each title of these plots fits in two lines.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  void setWidth(int width);

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
};

/// Names, colors and values of the curves of one plot, shown beside it in the unit of its title.
/// Drawn on the layer of the cursor, so that moving the cursor does not redraw curves.
class PlotReadout : public QCPLayoutElement {
public:
  PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// Returns the width in pixels that the readouts of these plots need to form one column.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  /// Returns the number of text lines that the readout of a plot takes.
  static int linesOf(const PlotDeclaration& plot);
  /// Height of a text line in readouts and captions, pixels.
  static int lineHeight(const QFont& font);
  void setWidth(int width);
  void setValues(std::vector<double> values) { values_ = std::move(values); }
  /// Sets whether a ground truth is known; it then has an entry.
  void setTruthKnown(bool known) { truthKnown_ = known; }
  /// Returns the readout as a sentence: "x 12 mm, y 9 mm".
  QString asText() const;

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
  std::vector<double> values_;
  bool truthKnown_ = false;
};

} // namespace dewpoint::ui
