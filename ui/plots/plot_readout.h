// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"

#include <qcustomplot.h>

#include <vector>

namespace dewpoint::ui {

/// Layout element with the title of one plot and its unit, in up to two lines to the left of the
/// axis numbers.
class PlotCaption : public QCPLayoutElement {
public:
  PlotCaption(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// Returns the width, in pixels, in which every title of these plots fits in two lines.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  void setWidth(int width);

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
};

/// Layout element next to a plot with the names, colors and values of its curves at the cursor, in
/// the unit of the title. The readout is drawn on the cursor layer, so that moving the cursor does
/// not redraw curves.
class PlotReadout : public QCPLayoutElement {
public:
  PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration);
  /// Returns the width, in pixels, of a column in which the readouts of all these plots fit.
  static int widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font);
  /// Returns the number of text lines in a plot's readout.
  static int lineCount(const PlotDeclaration& plot);
  /// Returns the height of a text line in readouts and captions, in pixels.
  static int lineHeight(const QFont& font);
  void setWidth(int width);
  void setValues(std::vector<double> values) { values_ = std::move(values); }
  /// Sets whether a ground truth is known. If so, the readout has an entry for it.
  void setHasGroundTruth(bool known) { truthKnown_ = known; }
  /// Returns values of a plot's curves as text: "x 12 mm, y 9 mm".
  static QString textOf(const PlotDeclaration& plot, const std::vector<double>& values);

protected:
  void draw(QCPPainter* painter) override;

private:
  const PlotDeclaration& declaration_;
  std::vector<double> values_;
  bool truthKnown_ = false;
};

} // namespace dewpoint::ui
