// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbolic_icon.h"

#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <gtest/gtest.h>

#include <cstdlib>

namespace dewpoint::tests {
namespace {

QPalette textColors(const QColor& enabled, const QColor& disabled) {
  QPalette palette;
  palette.setColor(QPalette::Active, QPalette::ButtonText, enabled);
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, disabled);
  return palette;
}

/// Returns the color of the most opaque pixel.
QColor strokeColor(const QPixmap& pixmap) {
  const QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
  QColor stroke(Qt::transparent);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      stroke = color.alpha() > stroke.alpha() ? color : stroke;
    }
  }
  return stroke;
}

bool areClose(const QColor& one, const QColor& other) {
  constexpr int kRounding = 3; // of premultiplied colors
  return std::abs(one.red() - other.red()) <= kRounding &&
         std::abs(one.green() - other.green()) <= kRounding &&
         std::abs(one.blue() - other.blue()) <= kRounding;
}

TEST(SymbolicIcon, HasTheTextColorOfThePalette) {
  const QColor blue(20, 60, 200);
  const QColor gray(150, 150, 150);
  const QIcon icon = symbolicIcon(QStringLiteral("reset"), textColors(blue, gray));
  EXPECT_TRUE(areClose(strokeColor(icon.pixmap(32)), blue));
  EXPECT_TRUE(areClose(strokeColor(icon.pixmap({32, 32}, QIcon::Disabled)), gray));
  // The same icon in other colors is not taken for this one.
  const QColor white(250, 250, 250);
  const QIcon dark = symbolicIcon(QStringLiteral("reset"), textColors(white, gray));
  EXPECT_TRUE(areClose(strokeColor(dark.pixmap(32)), white));
  EXPECT_TRUE(areClose(strokeColor(icon.pixmap(32)), blue));
}

TEST(SymbolicIcon, IsDrawnAtTheSizeOfTheScreen) {
  const QIcon icon = symbolicIcon(QStringLiteral("reset"), textColors(Qt::black, Qt::darkGray));
  for (const int size : {14, 16, 33, 128}) {
    EXPECT_EQ(icon.pixmap(size).size(), QSize(size, size));
    EXPECT_EQ(icon.pixmap({size, size}, 2.0).size(), QSize(2 * size, 2 * size));
  }
  EXPECT_DOUBLE_EQ(icon.pixmap({16, 16}, 2.0).devicePixelRatio(), 2.0);
  // It keeps its shape in an area that is not square.
  const QImage wide = icon.pixmap({64, 32}).toImage();
  for (int y = 0; y < wide.height(); ++y) {
    EXPECT_EQ(wide.pixelColor(4, y).alpha(), 0);
    EXPECT_EQ(wide.pixelColor(59, y).alpha(), 0);
  }
}

TEST(SymbolicIcon, IsPaintedWhereItIsAsked) {
  const QIcon icon = symbolicIcon(QStringLiteral("reset"), textColors(Qt::red, Qt::darkGray));
  QImage image(80, 80, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(2.0);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  icon.paint(&painter, 20, 20, 16, 16);
  painter.end();
  QRect drawn;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      drawn |= image.pixelColor(x, y).alpha() > 0 ? QRect(x, y, 1, 1) : QRect();
    }
  }
  EXPECT_FALSE(drawn.isEmpty());
  EXPECT_TRUE(QRect(40, 40, 32, 32).contains(drawn));
}

TEST(SymbolicIcon, AnUnknownOneIsNull) {
  EXPECT_TRUE(symbolicIcon(QStringLiteral("no such icon"), QPalette()).isNull());
}

} // namespace
} // namespace dewpoint::tests
