// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/pick_marks.h"

#include <QFont>
#include <QFontMetricsF>
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

} // namespace
} // namespace dewpoint::tests
