// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QStyledItemDelegate>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Content of a row in the list of targets, in addition to the name.
struct TargetRow {
  QColor identityColor;               ///< target color in all views
  std::optional<QColor> learnedColor; ///< learned target color; empty if the target needs no color
  std::optional<TrackingState> state; ///< empty without a run
  QString sizeText;
  QString speedText;   ///< empty if unknown
  bool isShown = true; ///< whether the views draw the target

  bool operator==(const TargetRow&) const = default;
};

/// Draws the targets in a list, each in two lines. The first line has a disc in the learned color,
/// inside a ring in the target's color in the views; the name; and the state as a word, shape and
/// color. The second line has the size, and the speed below the state. An eye at the right end
/// shows whether the views draw the target; a click on it changes this.
class TargetRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// Sets the content of all rows. Returns whether it differs from the previous content.
  bool setRows(std::vector<TargetRow> rows);
  const std::vector<TargetRow>& rows() const { return rows_; }
  /// Returns the area of the eye symbol in a row of the list whose area is `row`.
  static QRect eyeIconArea(const QRect& row);

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;

Q_SIGNALS:
  void eyeIconClicked(int row);

protected:
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

private:
  std::vector<TargetRow> rows_;
};

} // namespace dewpoint::ui
