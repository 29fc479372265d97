// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QStyledItemDelegate>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Content of the row of a target besides its name.
struct TargetRow {
  QColor identity;                ///< color of the target in all views
  std::optional<QColor> learned;  ///< learned color of the target; nothing if it needs no color
  std::optional<HoldState> state; ///< nothing without a run
  QString size;

  bool operator==(const TargetRow&) const = default;
};

/// Draws the targets of a list in two lines. First: a disc in the learned color, inside a ring in
/// the color of the target in the views; the name; and the state as a word, shape and color.
/// Second: the size.
class TargetRowDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// Sets the rows; returns whether they differ from the previous ones.
  bool setRows(std::vector<TargetRow> rows);
  const std::vector<TargetRow>& rows() const { return rows_; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
  std::vector<TargetRow> rows_;
};

} // namespace dewpoint::ui
