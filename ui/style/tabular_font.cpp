// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/tabular_font.h"

#include <QFontDatabase>
#include <QFontMetricsF>

#include <cmath>

namespace dewpoint::ui {

namespace {

bool hasTabularDigits(const QFont& font) {
  const QFontMetricsF metrics(font);
  const double zero = metrics.horizontalAdvance(QLatin1Char('0'));
  for (char digit = '1'; digit <= '9'; ++digit) {
    if (std::abs(metrics.horizontalAdvance(QLatin1Char(digit)) - zero) > 0.01) {
      return false;
    }
  }
  return true;
}

QFont chosenFont(const QFont& font) {
  if (hasTabularDigits(font)) {
    return font;
  }
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  if (font.pixelSize() > 0) {
    fixed.setPixelSize(font.pixelSize());
  } else {
    fixed.setPointSizeF(font.pointSizeF());
  }
  fixed.setWeight(font.weight());
  return fixed;
}

} // namespace

QFont tabularFont(const QFont& font) {
  // Tables ask for each of their cells, all with the same font.
  static QFont askedLast = font;
  static QFont chosenLast = chosenFont(font);
  if (font != askedLast) {
    askedLast = font;
    chosenLast = chosenFont(font);
  }
  return chosenLast;
}

} // namespace dewpoint::ui
