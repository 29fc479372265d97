// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/tabular_font.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(TabularFont, DigitsAreEquallyWideInAnyFont) {
  for (const QString& family : QFontDatabase::families()) {
    const QFont font(family, 9);
    const QFont chosen = tabularFont(font);
    const QFontMetricsF metrics(chosen);
    EXPECT_NEAR(metrics.horizontalAdvance(QStringLiteral("1111")),
                metrics.horizontalAdvance(QStringLiteral("0000")), 0.1)
        << family.toStdString();
    EXPECT_EQ(chosen.pointSizeF(), font.pointSizeF());
  }
}

} // namespace
} // namespace dewpoint::tests
