// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/pick_marks.h"

#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(PickMarks, AHintIsDividedWhereItsPartsEnd) {
  const QString hint =
      QStringLiteral("Click: learn · Shift: add · Ctrl+Shift: exclude · Esc: stop");
  const QFontMetricsF metrics((QFont()));
  const double whole = metrics.horizontalAdvance(hint);
  EXPECT_EQ(pickHintLines(hint, metrics, whole + 1.0), QStringList{hint});
  const QStringList lines = pickHintLines(hint, metrics, 0.7 * whole);
  EXPECT_EQ(lines.size(), 2);
  for (const QString& line : lines) {
    EXPECT_LE(metrics.horizontalAdvance(line), 0.7 * whole) << line.toStdString();
  }
  EXPECT_EQ(lines.join(QStringLiteral(" · ")), hint);
  EXPECT_EQ(pickHintLines(hint, metrics, 1.0).size(), 4); // no part is divided
}

/// Rows above the region that its label covers.
int rowsOfLabel(int width, const QString& text) {
  QImage image(width, 200, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  const QRectF region(width / 2.0 - 10.0, 150.0, 20.0, 20.0);
  paintPickRegion(painter, QPolygonF(region), text, image.size());
  painter.end();
  int rows = 0;
  for (int y = 0; y < 145; ++y) {
    rows += image.pixelColor(width / 2, y) != QColor(Qt::white) ? 1 : 0;
  }
  return rows;
}

TEST(PickMarks, ALongLabelOfARegionIsDivided) {
  const QString text =
      QStringLiteral("recognized as the target (if this is wrong, Ctrl+Shift-click here)");
  const int one = rowsOfLabel(2000, text);
  EXPECT_GT(one, 5);
  const double whole = QFontMetricsF(QFont()).horizontalAdvance(text);
  EXPECT_GT(rowsOfLabel(static_cast<int>(0.6 * whole), text), one + one / 2);
}

} // namespace
} // namespace dewpoint::tests
