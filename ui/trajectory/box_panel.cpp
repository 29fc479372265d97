// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/box_panel.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/selection/selection.h"
#include "ui/text/retranslation.h"
#include "ui/trajectory/box_model.h"
#include "ui/trajectory/frame_row_delegate.h"

#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kIntervalMs = 150;
}

BoxPanel::BoxPanel(Selection& selection, QWidget* parent)
    : QWidget(parent), model_(new BoxModel(this)), table_(new QTableView(this)),
      summary_(new QLabel(this)) {
  setObjectName(QStringLiteral("boxPanel"));
  summary_->setObjectName(QStringLiteral("boxSummary"));
  summary_->setContentsMargins(8, 4, 8, 4);
  summary_->setWordWrap(true);
  table_->setObjectName(QStringLiteral("boxTable"));
  table_->setModel(model_);
  head_ = new FrameRowDelegate(table_, selection, [this](qint64 frame) {
    const auto& samples = model_->samples();
    const auto first = std::ranges::lower_bound(samples, frame, {}, &BoxSample::frame);
    const auto last = std::ranges::upper_bound(samples, frame, {}, &BoxSample::frame);
    return std::pair(static_cast<int>(first - samples.begin()),
                     static_cast<int>(last - samples.begin()));
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(summary_);
  column->addWidget(table_, 1);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &BoxPanel::fetch);
  connect(table_, &QTableView::activated, this, [this, &selection](const QModelIndex& index) {
    selection.requestFrame(model_->samples()[static_cast<std::size_t>(index.row())].frame);
  });
  connect(table_, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
    Q_EMIT contextMenuRequested(table_->viewport()->mapToGlobal(place));
  });
  onRetranslate(this, [this] {
    table_->setAccessibleName(tr("Boxes of the targets"));
    const QFontMetrics metrics = table_->fontMetrics();
    for (int part = 0; part < BoxModel::ColumnCount; ++part) {
      const QString title = model_->headerData(part, Qt::Horizontal).toString();
      const QString widest = part == BoxModel::Target ? QStringLiteral("pink ball 1")
                             : part == BoxModel::Seen ? BoxModel::tr("◌ hidden")
                                                      : QStringLiteral("0000.00");
      table_->setColumnWidth(
          part, 16 + std::max(metrics.horizontalAdvance(title), metrics.horizontalAdvance(widest)));
    }
    updateSummary();
  });
}

void BoxPanel::setSource(Source source) {
  source_ = std::move(source);
  generation_ = 0;
  position_ = 0;
  model_->clear();
  updateSummary();
  refresh();
}

void BoxPanel::refresh() {
  if (isVisible() && !timer_.isActive()) {
    timer_.start(kIntervalMs);
  }
}

void BoxPanel::fetch() {
  if (!source_) {
    return;
  }
  const LogUpdate<BoxSample> piece = source_(generation_, position_);
  if (piece.restarted || !piece.records.empty()) {
    model_->replaceFrom(piece.first, piece.records);
  }
  head_->refresh();
  updateSummary();
}

void BoxPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  if (!snapshot) {
    return;
  }
  QStringList names;
  for (const TargetSnapshot& target : snapshot->targets) {
    names.append(QString::fromStdString(target.target.name));
  }
  model_->setTargetNames(names);
}

QByteArray BoxPanel::csv() {
  fetch();
  BoxTrack track;
  track.samples = model_->samples();
  if (const auto rows = table_->selectionModel()->selection(); !rows.isEmpty()) {
    const auto first = track.samples.begin();
    track.samples = {first + rows.first().top(), first + rows.first().bottom() + 1};
  }
  return QByteArray::fromStdString(boxCsv(track));
}

void BoxPanel::updateSummary() {
  const int rows = model_->rowCount();
  summary_->setText(
      rows == 0 ? tr("This method tracks boxes in images. Click the object or drag a box around it "
                     "in any camera view. Its box in each frame appears here, in pixels.")
                : tr("%n boxes (coordinates in image pixels)", nullptr, rows));
}

void BoxPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

} // namespace dewpoint::ui
