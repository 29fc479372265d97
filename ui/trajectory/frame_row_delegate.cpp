// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/frame_row_delegate.h"

#include "ui/selection/selection.h"
#include "ui/style/tabular_font.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>

#include <algorithm>

namespace dewpoint::ui {

namespace {
constexpr float kMarkStrength = 0.25F; ///< of the color of what is selected
} // namespace

FrameRowDelegate::FrameRowDelegate(QTableView* table, Selection& selection, RowsOf rowsOf)
    : QStyledItemDelegate(table), table_(table), selection_(selection), rowsOf_(std::move(rowsOf)) {
  prepare();
  const QScrollBar* bar = table->verticalScrollBar();
  connect(bar, &QScrollBar::valueChanged, this, &FrameRowDelegate::onScrolled);
  connect(bar, &QScrollBar::rangeChanged, this,
          &FrameRowDelegate::follow); // more rows, or less room
  connect(&selection, &Selection::currentFrameChanged, this, &FrameRowDelegate::refresh);
  const auto followAgain = [this] { following_ = true; };
  connect(&selection, &Selection::frameRequested, this, followAgain);
  connect(&selection, &Selection::liveFrameRequested, this, followAgain);
}

void FrameRowDelegate::prepare() {
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ContiguousSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setAlternatingRowColors(true);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setWordWrap(false);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setItemDelegate(this);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerItem); // positions are rows
  // All rows of one height: nothing is measured as the table grows.
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->horizontalHeader()->setHighlightSections(false);
}

void FrameRowDelegate::refresh() {
  const qint64 frame = selection_.currentFrame();
  const auto rows = frame < 0 ? std::pair(0, 0) : rowsOf_(frame);
  if (rows != rows_) {
    rows_ = rows;
    table_->viewport()->update();
  }
  follow();
}

int FrameRowDelegate::rowToShow() const {
  const int end = table_->model()->rowCount() - 1;
  if (selection_.currentFrame() < 0) {
    return end;
  }
  const auto [first, last] = rowsOf_(selection_.currentFrame());
  return std::min(std::max(first, last - 1), end);
}

int FrameRowDelegate::visibleRowCount() const {
  const int height = std::max(1, table_->verticalHeader()->defaultSectionSize());
  return std::max(1, table_->viewport()->height() / height);
}

bool FrameRowDelegate::isRowVisible(int row) const {
  const QScrollBar* bar = table_->verticalScrollBar();
  const bool isEnd = bar->value() == bar->maximum() && row == table_->model()->rowCount() - 1;
  return isEnd || (row >= bar->value() && row < bar->value() + visibleRowCount());
}

void FrameRowDelegate::follow() {
  const int row = rowToShow();
  if (!following_ || moving_ || row < 0 || selection_.selectedRange()) {
    return;
  }
  QScrollBar* bar = table_->verticalScrollBar();
  moving_ = true;
  if (row == table_->model()->rowCount() - 1) {
    bar->setValue(bar->maximum());
  } else if (!isRowVisible(row)) {
    bar->setValue(row - visibleRowCount() / 2);
  }
  moving_ = false;
}

void FrameRowDelegate::onScrolled() {
  if (!moving_) {
    const int row = rowToShow();
    following_ = row < 0 || isRowVisible(row);
  }
}

void FrameRowDelegate::initStyleOption(QStyleOptionViewItem* option,
                                       const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  option->font = tabularFont(option->font);
  if (index.row() >= rows_.first && index.row() < rows_.second) {
    QColor mark = option->palette.color(QPalette::Highlight);
    mark.setAlphaF(kMarkStrength);
    option->backgroundBrush = mark;
  }
}

} // namespace dewpoint::ui
