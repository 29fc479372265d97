// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStyledItemDelegate>

namespace dewpoint::ui {

/// Draws the items of a MethodChoice: headings, and methods in two lines. The name used in files is
/// at the right edge, with the paper below it.
class MethodItemDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace dewpoint::ui
