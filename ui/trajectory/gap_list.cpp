// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/gap_list.h"

#include "ui/text/quantity_text.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>

namespace dewpoint::ui {

GapList::GapList(QWidget* parent) : QTableWidget(0, 4, parent) {
  setObjectName(QStringLiteral("gapList"));
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setTabKeyNavigation(false);
  setFrameShape(QFrame::NoFrame);
  setShowGrid(false);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  horizontalHeader()->setStretchLastSection(true);
  horizontalHeader()->setHighlightSections(false);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = selectionModel()->selectedRows();
    if (!rows.isEmpty()) {
      const TrajectoryGap& gap = gaps_[static_cast<std::size_t>(rows.front().row())];
      Q_EMIT gapChosen(gap.firstFrame, gap.lastFrame);
    }
  });
  fill();
  resizeColumnsToContents();
}

void GapList::setGaps(std::vector<TrajectoryGap> gaps) {
  if (gaps.size() > kMaxGaps) {
    gaps.erase(gaps.begin(), gaps.end() - kMaxGaps);
  }
  if (gaps != gaps_) {
    gaps_ = std::move(gaps);
    fill();
  }
}

void GapList::setSelectedRange(std::optional<SelectedRange> selectedRange) {
  const QSignalBlocker quiet(this);
  const auto found = std::ranges::find_if(gaps_, [&](const TrajectoryGap& gap) {
    return selectedRange && gap.firstFrame == selectedRange->first &&
           gap.lastFrame == selectedRange->last;
  });
  if (found == gaps_.end()) {
    clearSelection();
  } else if (const int row = static_cast<int>(found - gaps_.begin()); row != currentRow()) {
    selectRow(row);
  }
}

void GapList::fill() {
  const QSignalBlocker quiet(this);
  setAccessibleName(tr("Gaps of the trajectory"));
  setHorizontalHeaderLabels({tr("gap from"), tr("to"), tr("length"), tr("target")});
  setRowCount(static_cast<int>(gaps_.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const TrajectoryGap& gap = gaps_[static_cast<std::size_t>(row)];
    const QStringList texts{tr("frame %1").arg(frameNumberText(gap.firstFrame)),
                            tr("frame %1").arg(frameNumberText(gap.lastFrame)),
                            secondsText(gap.durationSeconds(), 2) + QStringLiteral(" · ") +
                                tr("%n frames", nullptr, static_cast<int>(gap.frameCount())),
                            QString::fromStdString(gap.target)};
    for (int column = 0; column < columnCount(); ++column) {
      auto* cell = item(row, column);
      if (cell == nullptr) {
        cell = new QTableWidgetItem;
        setItem(row, column, cell);
      }
      cell->setText(texts[column]);
      cell->setToolTip(tr("Time in seconds between the last tracked frame before the gap and the "
                          "first tracked frame after it"));
    }
  }
  widen();
}

/// Every title and every number is there whole; what was once wide stays so, or a growing list
/// would tremble.
void GapList::widen() {
  for (int column = 0; column < columnCount(); ++column) {
    const int wanted =
        std::max(horizontalHeader()->sectionSizeHint(column), sizeHintForColumn(column));
    const bool isLast = column == columnCount() - 1; // it has all the room that is left
    setColumnWidth(column, isLast ? wanted : std::max(columnWidth(column), wanted));
  }
}

void GapList::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    fill();
    resizeColumnsToContents(); // the words are others
  } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
    widen();
  }
}

} // namespace dewpoint::ui
