// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tab_order.h"

#include <QGridLayout>
#include <QLayoutItem>
#include <QWidget>

namespace dewpoint::ui {

void orderTabsByRows(const QGridLayout& grid) {
  QWidget* before = nullptr;
  for (int row = 0; row < grid.rowCount(); ++row) {
    for (int column = 0; column < grid.columnCount(); ++column) {
      const QLayoutItem* const item = grid.itemAtPosition(row, column);
      QWidget* const field = item != nullptr ? item->widget() : nullptr;
      if (field == nullptr || field == before || (field->focusPolicy() & Qt::TabFocus) == 0) {
        continue; // empty, the same one in its next column, or a label
      }
      if (before != nullptr) {
        QWidget::setTabOrder(before, field);
      }
      before = field;
    }
  }
}

} // namespace dewpoint::ui
