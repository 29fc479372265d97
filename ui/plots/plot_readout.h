// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"

#include <qcustomplot.h>

#include <vector>

namespace dewpoint::ui {

/// Title of one plot with its unit, left of the numbers of its axis, in up to two lines.
class PlotCaption : public QCPLayoutElement {
public:
  PlotCaption(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// So wide that the titles of these plots fit in two lines each.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  void setWidth(int width);

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
};

/// Names, colors and values of the curves of one plot, beside it, in the unit of its title. Drawn
/// on the cursor's layer, so that moving the cursor draws no curve again.
class PlotReadout : public QCPLayoutElement {
public:
  PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// So wide that these plots' readouts stand in one column.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  /// Lines of text that the plot's entries take.
  static int linesOf(const PlotDeclaration& plot);
  /// Height of a line of text in readouts and captions.
  static int lineHeight(const QFont& font);
  void setWidth(int width);
  void setValues(std::vector<double> values) { values_ = std::move(values); }
  /// Whether there is a truth among the curves, which has an entry then.
  void setTruthKnown(bool known) { truthKnown_ = known; }
  /// "x 12 mm, y 9 mm": what is written, as a sentence.
  QString asText() const;

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
  std::vector<double> values_;
  bool truthKnown_ = false;
};

} // namespace dewpoint::ui
