// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStyledItemDelegate>

#include <functional>
#include <utility>

class QTableView;

namespace dewpoint::ui {

class Selection;

/// Delegate of a table with one or more rows per frame. It highlights the rows of the frame shown
/// and scrolls them into view. It does not scroll while a range is selected, or after the user has
/// scrolled them out of view, until they are scrolled back or a frame is requested. All rows have
/// the same height.
class TableHead : public QStyledItemDelegate {
  Q_OBJECT
public:
  /// Returns the rows [first, last) of a frame. If it has none, both are the index where they would
  /// be.
  using RowsOf = std::function<std::pair<int, int>(qint64 frame)>;

  TableHead(QTableView* table, Selection& selection, RowsOf rowsOf);

  /// Updates after the rows of the table or the frame shown have changed.
  void refresh();
  /// Highlighted rows.
  std::pair<int, int> rows() const { return rows_; }

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
  void prepare();
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
  bool moving_ = false; ///< the table is being scrolled by the program
};

} // namespace dewpoint::ui
