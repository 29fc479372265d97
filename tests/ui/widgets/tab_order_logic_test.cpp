// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the Tab key visits the fields of a grid.
#include "ui/widgets/tab_order.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(TabOrder, GoesRowByRow) {
  QWidget page;
  auto* grid = new QGridLayout(&page);
  // Made column by column, as fields often are.
  QLineEdit* fields[2][2];
  for (int column = 0; column < 2; ++column) {
    for (int row = 0; row < 2; ++row) {
      fields[row][column] = new QLineEdit(&page);
      grid->addWidget(fields[row][column], 2 * row + 1, column);
    }
  }
  grid->addWidget(new QLabel(&page), 0, 0, 1, 2);
  auto* last = new QLineEdit(&page);
  grid->addWidget(last, 4, 0, 1, 2);
  orderTabsByRows(*grid);
  const auto next = [](const QWidget* field) {
    QWidget* after = field->nextInFocusChain();
    while (after->focusPolicy() == Qt::NoFocus) {
      after = after->nextInFocusChain();
    }
    return after;
  };
  EXPECT_EQ(next(fields[0][0]), fields[0][1]);
  EXPECT_EQ(next(fields[0][1]), fields[1][0]);
  EXPECT_EQ(next(fields[1][0]), fields[1][1]);
  EXPECT_EQ(next(fields[1][1]), last);
}

} // namespace
} // namespace dewpoint::tests
