// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStyledItemDelegate>

#include <functional>
#include <utility>

class QTableView;

namespace dewpoint::ui {

class Selection;

/// Marks the rows of the frame shown in a table with one or more rows per frame, and keeps them in
/// sight: not while a range is selected, nor once the user has scrolled them out of sight, until
/// they are scrolled back or a frame is requested. The table's delegate; rows are of one height.
class TableHead : public QStyledItemDelegate {
  Q_OBJECT
public:
  /// Rows [first, last) of a frame; where it has none, both are where they would be.
  using RowsOf = std::function<std::pair<int, int>(qint64 frame)>;

  TableHead(QTableView* table, Selection& selection, RowsOf rowsOf);

  /// The table has other rows, or another frame is shown.
  void refresh();
  /// The rows that are marked.
  std::pair<int, int> rows() const { return rows_; }

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
  /// The row to be seen: the last of the frame shown, or of all; -1: none.
  int wantedRow() const;
  int rowsInSight() const;
  bool isInSight(int row) const;
  void follow();
  void scrolled();

  QTableView* table_;
  Selection& selection_;
  RowsOf rowsOf_;
  std::pair<int, int> rows_;
  bool following_ = true;
  bool moving_ = false; ///< the table is being scrolled, but not by the user
};

} // namespace dewpoint::ui
