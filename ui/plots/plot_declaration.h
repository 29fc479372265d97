// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Quantity of a plot. It determines how numbers are written and how the axis is fitted.
enum class PlotQuantity {
  Length,        ///< meters; drawn in millimeters on a logarithmic axis
  Position,      ///< meters
  Speed,         ///< meters per second
  Count,         ///< axis from 0
  Duration,      ///< microseconds, axis from 0
  LogLikelihood, ///< natural logarithm
  Probability,   ///< 0 to 1
  Pixels,        ///< in an image, axis from 0
  PixelPosition, ///< position in an image, pixels
};

/// Declares one curve of a plot.
struct CurveDeclaration {
  QString name;           ///< translated; "x", "camera 1"
  QString csvName;        ///< column name in a table, with the unit: "spread_x_mm"
  std::size_t column = 0; ///< column of the PlotSeries
  int color = 0;          ///< index for curveColor()
  /// Column of the standard deviation: a band of two standard deviations is drawn around the curve.
  std::optional<std::size_t> deviation = std::nullopt;
  /// Column of the ground truth: a thin dashed line.
  std::optional<std::size_t> truth = std::nullopt;
  QString truthCsvName = {}; ///< column name in a table: "true_x_m"
};

/// Declares one plot of a stack.
struct PlotDeclaration {
  QString id; ///< "spread"
  QString title;
  PlotQuantity quantity = PlotQuantity::Count;
  std::vector<CurveDeclaration> curves;
};

/// Returns a value with its unit and a suitable precision; "–" if it is not a number.
QString quantityText(PlotQuantity quantity, double value);
/// Returns the number without its unit, in the unit of the axis. The number of decimals does not
/// change with the value.
QString drawnNumberText(PlotQuantity quantity, double value);
/// Unit of the axis; may be empty.
QString axisUnit(PlotQuantity quantity);
/// Title with the unit of the axis: "Spread (mm)".
QString titleWithUnit(const PlotDeclaration& plot);
/// Converts a stored value to the unit of the axis and of tables.
double drawnValue(PlotQuantity quantity, double value);

/// Color of a curve, safe for color-blind users (Okabe-Ito, darker on a light background). A
/// negative index: the color of text.
QColor curveColor(int index, const QColor& text);

} // namespace dewpoint::ui
