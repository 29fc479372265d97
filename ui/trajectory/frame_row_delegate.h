// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStyledItemDelegate>

#include <functional>
#include <utility>

class QTableView;

namespace dewpoint::ui {

class Selection;

/// Delegate for a table with one or more rows per frame. It highlights the rows of the frame shown,
/// and scrolls them into view unless a range is selected. If the user scrolls these rows out of
/// view, automatic scrolling stops until the user scrolls back or requests a frame. All rows have
/// the same height.
class FrameRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
public:
  /// Function that returns the rows [first, last) of a frame. If the frame has no rows, both values
  /// are the index where its rows would be.
  using RowsOf = std::function<std::pair<int, int>(qint64 frame)>;

  FrameRowDelegate(QTableView* table, Selection& selection, RowsOf rowsOf);

  /// Updates the highlight and the scroll position. Call this after the rows of the table or the
  /// frame shown have changed.
  void refresh();
  /// Returns the highlighted rows.
  std::pair<int, int> rows() const { return rows_; }

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
  void prepare();
  /// Returns the row that should be visible: the last row of the frame shown, or the last row of
  /// the table, or -1 if there is none.
  int rowToShow() const;
  int visibleRowCount() const;
  bool isRowVisible(int row) const;
  void follow();
  void onScrolled();

  QTableView* table_;
  Selection& selection_;
  RowsOf rowsOf_;
  std::pair<int, int> rows_;
  bool following_ = true;
  bool moving_ = false; ///< the program is scrolling the table
};

} // namespace dewpoint::ui
