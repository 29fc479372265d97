// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/preview_pane.h"

#include "ui/export/export_text.h"
#include "ui/widgets/named.h"

#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kPreviewDelayMs = 150;
constexpr int kSoonDoneMs = 500; ///< less needs no button to stop it

} // namespace

PreviewPane::PreviewPane(ExportJobs& jobs, std::function<void()> order, QWidget* parent)
    : QWidget(parent), jobs_(jobs), units_(named(new QLabel(this), "exportUnits")),
      size_(named(new QLabel(this), "exportSize")),
      old_(named(new QLabel(this), "exportOldResults")),
      lines_(named(new QPlainTextEdit(this), "exportPreview")), startTimer_(new QTimer(this)),
      longTimer_(new QTimer(this)) {
  units_->setWordWrap(true);
  size_->setWordWrap(true);
  old_->setWordWrap(true);
  old_->hide();
  lines_->setReadOnly(true);
  lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
  lines_->setTabChangesFocus(true);
  lines_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(units_);
  column->addWidget(size_);
  column->addWidget(old_);
  column->addWidget(lines_, 1);
  startTimer_->setSingleShot(true);
  startTimer_->setInterval(kPreviewDelayMs);
  longTimer_->setSingleShot(true);
  longTimer_->setInterval(kSoonDoneMs);
  connect(startTimer_, &QTimer::timeout, this, [this, order = std::move(order)] {
    isUnderWay_ = true;
    longTimer_->start();
    order();
  });
  connect(longTimer_, &QTimer::timeout, this, &PreviewPane::previewTakesLong);
  connectJobs();
}

void PreviewPane::connectJobs() {
  connect(&jobs_, &ExportJobs::previewProgressChanged, this, [this](int percent) {
    if (isUnderWay_) {
      size_->setText(tr("Preparing the preview: %1 %").arg(percent));
    }
  });
  connect(&jobs_, &ExportJobs::previewReady, this, &PreviewPane::showPreview);
  connect(&jobs_, &ExportJobs::previewFailed, this, [this](const QString& sentence) {
    end();
    units_->clear();
    size_->setText(sentence);
    clearLines();
  });
}

void PreviewPane::retranslateUi() {
  lines_->setAccessibleName(tr("First lines of the file"));
  lines_->setToolTip(tr("First lines of the file"));
  units_->setAccessibleName(tr("Units and axes"));
  size_->setAccessibleName(tr("Size"));
  old_->setText(tr("Some of these results were tracked with earlier settings."));
}

void PreviewPane::setResultsOutdated(bool outdated) {
  old_->setVisible(outdated);
}

void PreviewPane::requestPreview() {
  startTimer_->start();
}

void PreviewPane::cancelPendingRequest() {
  startTimer_->stop();
}

bool PreviewPane::isBusy() const {
  return isUnderWay_ || startTimer_->isActive();
}

void PreviewPane::end() {
  isUnderWay_ = false;
  longTimer_->stop();
  Q_EMIT previewEnded();
}

void PreviewPane::cancelPreview() {
  startTimer_->stop();
  jobs_.stopPreview();
  end();
}

void PreviewPane::stopOnUserRequest() {
  jobs_.stopPreview();
  end();
  units_->clear();
  clearLines();
  size_->setText(tr("The preview was stopped. It starts again when you change a setting."));
}

void PreviewPane::setExporting(bool exporting) {
  if (isUnderWay_ && exporting) {
    size_->clear();
  } else if (isUnderWay_) {
    startTimer_->start();
  }
}

void PreviewPane::clearLines() {
  lines_->clear();
  noteLines_ = -1;
}

void PreviewPane::showPreview(const ExportPreview& preview) {
  end();
  units_->setText(exportUnitsText(preview));
  size_->setText(exportSizeText(preview));
  // Numbers are what people look for; the last note shows that there are others above. A preview
  // that follows the run stays where it was scrolled to.
  QScrollBar* scroll = lines_->verticalScrollBar();
  const int before = scroll->value();
  const int notes = static_cast<int>(preview.noteLineCount);
  lines_->setPlainText(QString::fromStdString(preview.text));
  scroll->setValue(notes == noteLines_ ? before : std::max(0, notes - 1));
  noteLines_ = notes;
}

} // namespace dewpoint::ui
