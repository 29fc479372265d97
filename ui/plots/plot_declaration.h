// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Quantity shown in a plot, which determines the number format and the axis range.
enum class PlotQuantity {
  Length,        ///< meters; drawn in millimeters on a logarithmic axis
  Position,      ///< meters
  Speed,         ///< meters per second
  Count,         ///< axis from 0
  Duration,      ///< microseconds, axis from 0
  LogLikelihood, ///< natural logarithm
  Probability,   ///< 0 to 1
  Pixels,        ///< length in an image, pixels; axis from 0
  PixelPosition, ///< position in an image, pixels
};

/// Declaration of one curve in a plot.
struct CurveDeclaration {
  QString name;           ///< translated, for example "x" or "camera 1"
  QString csvName;        ///< column name in a table, with the unit: "spread_x_mm"
  std::size_t column = 0; ///< column in the PlotSeries
  int colorIndex = 0;     ///< index for curveColor()
  /// Column of the standard deviation. If set, a band of two standard deviations is drawn around
  /// the curve.
  std::optional<std::size_t> deviation = std::nullopt;
  /// Column of the ground truth. If set, it is drawn as a thin dashed line.
  std::optional<std::size_t> truth = std::nullopt;
  QString truthCsvName = {}; ///< column name in a table: "true_x_m"
};

/// Declaration of one plot in a stack.
struct PlotDeclaration {
  QString id; ///< identifies the plot, for example "spread"
  QString title;
  PlotQuantity quantity = PlotQuantity::Count;
  std::vector<CurveDeclaration> curves;
};

/// Returns a value with its unit and a suitable precision; "–" if it is not a number.
QString quantityText(PlotQuantity quantity, double value);
/// Returns a value as text without the unit, converted to the axis unit. The number of decimals
/// does not depend on the value.
QString axisNumberText(PlotQuantity quantity, double value);
/// Returns the unit in which a quantity is shown on an axis; may be empty.
QString axisUnit(PlotQuantity quantity);
/// Returns the title of a plot with the axis unit, for example "Spread (mm)".
QString titleWithUnit(const PlotDeclaration& plot);
/// Converts a stored value to the unit used on the axis and in tables.
double valueInAxisUnit(PlotQuantity quantity, double value);

/// Returns a curve color that color-blind users can distinguish (Okabe-Ito, darker on a light
/// background). A negative index returns the text color.
QColor curveColor(int index, const QColor& text);

} // namespace dewpoint::ui
