// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::ui {

/// What the numbers of a plot are: how they are written, and how the axis fits them.
enum class PlotQuantity {
  Length,        ///< meters; drawn in millimeters on a logarithmic axis
  Position,      ///< meters
  Speed,         ///< meters per second
  Count,         ///< from 0
  Duration,      ///< microseconds, from 0
  LogLikelihood, ///< natural logarithm
  Probability,   ///< 0 to 1
  Pixels,        ///< of an image, from 0
  PixelPosition, ///< in an image, pixels
};

struct CurveDeclaration {
  QString name;           ///< in the user's language; "x", "camera 1"
  QString csvName;        ///< column of a table, with its unit: "spread_x_mm"
  std::size_t column = 0; ///< of the PlotSeries
  int color = 0;          ///< see curveColor()
  /// Column of its standard deviation: a band of two of them lies about the curve.
  std::optional<std::size_t> deviation = std::nullopt;
  /// Column of what it truly is: a thin dashed line.
  std::optional<std::size_t> truth = std::nullopt;
  QString truthCsvName = {}; ///< column of a table: "true_x_m"
};

/// One plot of a stack.
struct PlotDeclaration {
  QString id; ///< "spread"
  QString title;
  PlotQuantity quantity = PlotQuantity::Count;
  std::vector<CurveDeclaration> curves;
};

/// A value with its unit, in the precision that makes sense; "–" when it is not a number.
QString quantityText(PlotQuantity quantity, double value);
/// The number alone in the unit of the axis, with decimals that stay the same while it changes.
QString drawnNumberText(PlotQuantity quantity, double value);
/// The unit of the axis; may be empty.
QString axisUnit(PlotQuantity quantity);
/// "Spread (mm)"
QString titleWithUnit(const PlotDeclaration& plot);
/// Number on the axis and in tables, for a value as it is stored.
double drawnValue(PlotQuantity quantity, double value);

/// Color-blind-safe (Okabe-Ito, darker on light ground). Negative: the color of text.
QColor curveColor(int index, const QColor& text);

} // namespace dewpoint::ui
