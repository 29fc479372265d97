// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/dewpoint_style.h"
#include "ui/style/theme.h"

#include <QComboBox>
#include <QHeaderView>
#include <QImage>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyleFactory>
#include <QTableView>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>

namespace dewpoint::tests {
namespace {

using ui::DewpointStyle;
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

INSTANTIATE_TEST_SUITE_P(Themes, StyleTest, ::testing::Bool());

} // namespace
} // namespace dewpoint::tests
