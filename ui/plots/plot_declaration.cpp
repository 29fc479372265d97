// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_declaration.h"

#include "core/base/units.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kLeastMm = 0.1; ///< a logarithmic axis has no zero

} // namespace

QString quantityText(PlotQuantity quantity, double value) {
  if (!std::isfinite(value)) {
    return QStringLiteral("–");
  }
  const auto number = [value](int decimals) {
    return numberText(value, decimals, NumberForm::Table);
  };
  switch (quantity) {
  case PlotQuantity::Length:
    return lengthText(value);
  case PlotQuantity::Position:
    return lengthText(value, LengthScale::Meters, 3, NumberForm::Table);
  case PlotQuantity::Speed:
    return speedText(value, NumberForm::Table);
  case PlotQuantity::Duration:
    return durationText(value);
  case PlotQuantity::Pixels:
  case PlotQuantity::PixelPosition:
    return pixelText(value);
  case PlotQuantity::LogLikelihood:
    return number(1);
  case PlotQuantity::Probability:
    return number(2);
  case PlotQuantity::Count:
    break;
  }
  return number(0);
}

QString axisNumberText(PlotQuantity quantity, double value) {
  switch (quantity) {
  case PlotQuantity::Length:
    return lengthNumber(value, LengthScale::Millimeters, 1, NumberForm::Table);
  case PlotQuantity::Position:
    return lengthNumber(value, LengthScale::Meters, 3, NumberForm::Table);
  case PlotQuantity::Speed:
  case PlotQuantity::Probability:
    return tableNumberText(value, 2);
  case PlotQuantity::LogLikelihood:
  case PlotQuantity::Pixels:
  case PlotQuantity::PixelPosition:
    return tableNumberText(value, 1);
  case PlotQuantity::Duration:
  case PlotQuantity::Count:
    break;
  }
  return tableNumberText(value, 0);
}

QString titleWithUnit(const PlotDeclaration& plot) {
  const QString unit = axisUnit(plot.quantity);
  return unit.isEmpty() ? plot.title
                        : QCoreApplication::translate("PlotQuantity", "%1 (%2)",
                                                      "title of a plot, unit of its axis")
                              .arg(plot.title, unit);
}

QString axisUnit(PlotQuantity quantity) {
  switch (quantity) {
  case PlotQuantity::Length:
    return QStringLiteral("mm");
  case PlotQuantity::Position:
    return QStringLiteral("m");
  case PlotQuantity::Speed:
    return QStringLiteral("m/s");
  case PlotQuantity::Duration:
    return QStringLiteral("µs");
  case PlotQuantity::Pixels:
  case PlotQuantity::PixelPosition:
    return QStringLiteral("px");
  case PlotQuantity::LogLikelihood:
  case PlotQuantity::Probability:
  case PlotQuantity::Count:
    break;
  }
  return {};
}

double valueInAxisUnit(PlotQuantity quantity, double value) {
  return quantity == PlotQuantity::Length ? std::max(kLeastMm, inMillimeters(value)) : value;
}

QColor curveColor(int index, const QColor& text) {
  static constexpr std::array<const char*, 6> kOnDark{"#56b4e9", "#e69f00", "#2fc79a",
                                                      "#cc79a7", "#f0e442", "#ff7f3f"};
  static constexpr std::array<const char*, 6> kOnLight{"#0072b2", "#c05a00", "#00734f",
                                                       "#a0457f", "#7a6a00", "#b01e1e"};
  if (index < 0) {
    return text;
  }
  const auto& colors = text.lightness() > 128 ? kOnDark : kOnLight;
  return QColor(colors[static_cast<std::size_t>(index) % colors.size()]);
}

} // namespace dewpoint::ui
