// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_declaration.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kLeastMm = 0.1; ///< a logarithmic axis has no zero

QString say(const char* text) {
  return QCoreApplication::translate("PlotQuantity", text);
}

QString number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

QString lengthText(double metres) {
  const double millimetres = metres * 1000.0;
  return std::abs(millimetres) < 10.0
             ? say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 mm")).arg(number(millimetres, 1))
         : std::abs(millimetres) < 1000.0
             ? say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 mm")).arg(number(millimetres, 0))
             : say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 m")).arg(number(metres, 2));
}

} // namespace

QString quantityText(PlotQuantity quantity, double value) {
  if (!std::isfinite(value)) {
    return QStringLiteral("–");
  }
  switch (quantity) {
  case PlotQuantity::Length:
    return lengthText(value);
  case PlotQuantity::Position:
    return say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 m")).arg(number(value, 3));
  case PlotQuantity::Speed:
    return say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 m/s")).arg(number(value, 2));
  case PlotQuantity::Duration:
    return value < 10000.0
               ? say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 µs")).arg(number(value, 0))
               : say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 ms")).arg(number(value / 1000.0, 1));
  case PlotQuantity::Pixels:
    return say(QT_TRANSLATE_NOOP("PlotQuantity", "%1 px")).arg(number(value, 1));
  case PlotQuantity::LogLikelihood:
    return number(value, 1);
  case PlotQuantity::Probability:
    return number(value, 2);
  case PlotQuantity::Count:
    break;
  }
  return number(value, 0);
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
    return QStringLiteral("px");
  case PlotQuantity::LogLikelihood:
  case PlotQuantity::Probability:
  case PlotQuantity::Count:
    break;
  }
  return {};
}

double drawnValue(PlotQuantity quantity, double value) {
  return quantity == PlotQuantity::Length ? std::max(kLeastMm, value * 1000.0) : value;
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
