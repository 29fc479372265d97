// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/dewpoint_style.h"
#include "ui/style/theme.h"

#include <QComboBox>
#include <QHeaderView>
#include <QImage>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyleFactory>
#include <QTableView>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

namespace dewpoint::tests {
namespace {

using ui::DewpointStyle;
using ui::progressColor;
using ui::themePalette;

/// How many colors there are along a column of what the widget draws, its edges left out.
std::size_t colorsDown(QWidget& widget, int column) {
  const QImage image = widget.grab().toImage();
  std::set<QRgb> colors;
  for (int row = 3; row < image.height() - 3; ++row) {
    colors.insert(image.pixel(column, row));
  }
  return colors.size();
}

class StyleTest : public ::testing::TestWithParam<bool> {
protected:
  void dress(QWidget& widget) {
    widget.setStyle(&style_);
    widget.setPalette(themePalette(GetParam()));
  }
  DewpointStyle style_;
};

TEST_P(StyleTest, ButtonsAreFlat) {
  QPushButton button;
  dress(button);
  button.resize(80, 28);
  EXPECT_EQ(colorsDown(button, 8), 1U);
  button.setDown(true);
  EXPECT_EQ(colorsDown(button, 8), 1U);

  QPushButton fusion;
  const std::unique_ptr<QStyle> plain(QStyleFactory::create("fusion"));
  fusion.setStyle(plain.get());
  fusion.setPalette(themePalette(GetParam()));
  fusion.resize(80, 28);
  EXPECT_GT(colorsDown(fusion, 8), 1U); // what the style is for
}

TEST_P(StyleTest, StatesOfAButtonDiffer) {
  const auto face = [this](const std::function<void(QPushButton&)>& change) {
    QPushButton button;
    dress(button);
    button.setCheckable(true);
    button.resize(80, 28);
    change(button);
    return button.grab().toImage().pixel(8, 14);
  };
  const std::set<QRgb> faces{face([](QPushButton&) {}),
                             face([](QPushButton& button) { button.setDown(true); }),
                             face([](QPushButton& button) { button.setChecked(true); }),
                             face([](QPushButton& button) { button.setEnabled(false); })};
  EXPECT_EQ(faces.size(), 4U);
}

TEST_P(StyleTest, DropDownBoxesAreFlat) {
  QComboBox box;
  dress(box);
  box.resize(120, 28);
  EXPECT_EQ(colorsDown(box, 8), 1U);
}

TEST_P(StyleTest, TableHeadsAreFlat) {
  QStandardItemModel model(2, 2);
  model.setHorizontalHeaderLabels({" ", " "});
  QTableView table;
  dress(table);
  dress(*table.horizontalHeader());
  table.setModel(&model);
  table.resize(300, 120);
  EXPECT_EQ(colorsDown(*table.horizontalHeader(), 20), 1U);
}

/// Relative luminance of a color, by WCAG 2.
double luminance(const QColor& color) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& one, const QColor& other) {
  const auto [dark, light] = std::minmax({luminance(one), luminance(other)});
  return (light + 0.05) / (dark + 0.05);
}

constexpr double kLegible = 4.5; ///< contrast of text, by WCAG 2 (level AA)

TEST_P(StyleTest, TextOnAProgressBarIsLegible) {
  QProgressBar bar;
  dress(bar);
  bar.resize(400, 24);
  bar.setRange(0, 100);
  bar.setFormat(QStringLiteral("Looking for the board: %p %"));
  const QPalette palette = themePalette(GetParam());
  const QColor text = palette.color(QPalette::Text);
  EXPECT_GE(contrast(text, progressColor(palette)), kLegible);
  EXPECT_GE(contrast(text, palette.color(QPalette::Base)), kLegible);
  for (const int value : {0, 50, 100}) {
    bar.setValue(value);
    const QImage image = bar.grab().toImage();
    // What is drawn: the ground on both sides, and the text in the middle, darkest or lightest.
    const QColor left = image.pixelColor(10, 12);
    const QColor right = image.pixelColor(390, 12);
    double best = 0.0;
    for (int x = 120; x < 280; ++x) {
      for (int y = 4; y < 20; ++y) {
        const QColor pixel = image.pixelColor(x, y);
        best = std::max(best, std::min(contrast(pixel, left), contrast(pixel, right)));
      }
    }
    EXPECT_GE(best, kLegible) << value;
    EXPECT_EQ(left == right, value != 50) << value;
  }
}

TEST_P(StyleTest, HintsAreLegible) {
  const QPalette palette = themePalette(GetParam());
  const QColor hint = palette.color(QPalette::PlaceholderText);
  for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::Button}) {
    EXPECT_GE(contrast(hint, palette.color(ground)), kLegible) << ground;
  }
}

INSTANTIATE_TEST_SUITE_P(Themes, StyleTest, ::testing::Bool());

} // namespace
} // namespace dewpoint::tests
