// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QStyledItemDelegate>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// What stands in the row of a target beside its name.
struct TargetRow {
  QColor identity;                ///< that it has in all views
  std::optional<QColor> learned;  ///< of the target itself; nothing where it needs no color
  std::optional<HoldState> state; ///< nothing without a run
  QString size;

  bool operator==(const TargetRow&) const = default;
};

/// Draws the targets of a list in two lines: a disc of the learned color in a ring of the color
/// that the target has in the views, the name and the state in word, shape and color; below it the
/// size.
class TargetRowDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// True when these are others than before.
  bool setRows(std::vector<TargetRow> rows);
  const std::vector<TargetRow>& rows() const { return rows_; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
  std::vector<TargetRow> rows_;
};

} // namespace dewpoint::ui
