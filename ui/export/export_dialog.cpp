// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_dialog.h"

#include "core/trajectory/export/export_catalog.h"
#include "ui/export/export_form.h"
#include "ui/export/export_layout.h"
#include "ui/export/export_outcome.h"
#include "ui/export/export_text.h"
#include "ui/export/preview_pane.h"
#include "ui/export/trajectory_figure.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

namespace dewpoint::ui {

namespace {

constexpr int kFollowMs = 2000;
constexpr std::size_t kMostToFollow = 20'000; ///< samples; to copy more takes noticeable time

} // namespace

ExportDialog::ExportDialog(std::function<Trajectory()> trajectory, QWidget* parent)
    : QDialog(parent), trajectorySource_(std::move(trajectory)), jobs_(new ExportJobs(this)),
      previewTimer_(new QTimer(this)) {
  setObjectName(QStringLiteral("exportDialog"));
  previewTimer_->setInterval(kFollowMs);
  makeFields();
  arrangeFields();
  onRetranslate(this, [this] { retranslateUi(); });
  connectFields();
  setRunning(false);
  resetChoices(QDir::home().filePath(QStringLiteral("trajectory")));
  resize(760, 660);
}

void ExportDialog::makeFields() {
  form_ = new ExportForm(this);
  preview_ = new PreviewPane(
      *jobs_, [this] { jobs_->startPreview(trajectory_, form_->options(), file()); }, this);
  outcome_ = new ExportOutcome(this);
  question_ = named(new QLabel(this), "exportQuestion");
  question_->setWordWrap(true);
  question_->hide();
  file_ = named(new QLineEdit(this), "exportFile");
  proposed_.emplace(*file_);
  browse_ = named(new QPushButton(this), "exportBrowse");
  progress_ = named(new QProgressBar(this), "exportProgress");
  progress_->setRange(0, 100);
  cancel_ = named(new QPushButton(this), "exportCancel");
  figure_ = named(new QPushButton(this), "exportFigure");
  export_ = named(new QPushButton(this), "exportStart");
  close_ = named(new QPushButton(this), "exportClose");
  // Enter in a field ends typing, no more.
  for (QPushButton* button : {browse_, cancel_, figure_, export_, close_}) {
    button->setAutoDefault(false);
  }
}

void ExportDialog::arrangeFields() {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(form_, 0, Qt::AlignTop); // its rows stay where they are when a message comes
  columns->addWidget(preview_, 1);
  arrangeExportDialog(
      *this, columns,
      {file_, browse_, question_, outcome_, progress_, cancel_, {figure_, export_}, close_});
}

void ExportDialog::retranslateUi() {
  setWindowTitle(tr("Export trajectory"));
  form_->retranslateUi();
  preview_->retranslateUi();
  outcome_->retranslateUi();
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("File to write"));
  browse_->setText(tr("Browse…"));
  browse_->setToolTip(tr("Choose the file to write"));
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(
      tr("Stop the export or the preview; files that already exist stay unchanged"));
  figure_->setText(tr("Figure…"));
  figure_->setToolTip(tr(
      "Save a figure of the trajectory as SVG or PDF: x, y, z over time, and the view from above"));
  withdrawQuestion(); // in the new language
  export_->setToolTip(tr("Write the file in the background"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close; a running export continues"));
  changed();
}

void ExportDialog::connectFields() {
  connect(preview_, &PreviewPane::previewTakesLong, cancel_, &QWidget::show);
  connect(preview_, &PreviewPane::previewEnded, this, [this] { cancel_->setVisible(running_); });
  connect(form_, &ExportForm::formatChanged, this, &ExportDialog::formatChanged);
  connect(form_, &ExportForm::changed, this, &ExportDialog::changed);
  connect(previewTimer_, &QTimer::timeout, this, &ExportDialog::updatePreview);
  connect(file_, &QLineEdit::textChanged, this, &ExportDialog::withdrawQuestion);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::chooseFile);
  connect(export_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(figure_, &QPushButton::clicked, this, &ExportDialog::startFigure);
  connect(cancel_, &QPushButton::clicked, this, &ExportDialog::stop);
  connect(jobs_, &ExportJobs::progressChanged, progress_, &QProgressBar::setValue);
  connect(jobs_, &ExportJobs::finished, this, &ExportDialog::showFinished);
  connect(jobs_, &ExportJobs::failed, this, [this](const QString& sentence) {
    setRunning(false);
    reportFailed(sentence);
  });
}

void ExportDialog::reportDone(const QString& sentence, const QString& file) {
  if (isVisible()) {
    outcome_->showResult(sentence, file);
  }
  if (!file.isEmpty()) {
    Q_EMIT fileWritten(file);
  }
  Q_EMIT completed(sentence);
}

void ExportDialog::reportFailed(const QString& sentence) {
  if (isVisible()) {
    outcome_->showResult(sentence);
  }
  Q_EMIT failed(sentence);
}

void ExportDialog::setResultsOutdated(bool outdated) {
  preview_->setResultsOutdated(outdated);
}

void ExportDialog::updatePreview() {
  if (running_ || preview_->isBusy() || !form_->exportsLiveEstimates() ||
      trajectory_->samples.size() > kMostToFollow) {
    return;
  }
  auto now = trajectorySource_();
  if (now.samples.size() != trajectory_->samples.size()) {
    trajectory_ = std::make_shared<const Trajectory>(std::move(now));
    form_->setTrajectory(*trajectory_);
    preview_->requestPreview();
  }
}

void ExportDialog::refresh() {
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_());
  form_->setTrajectory(*trajectory_);
  changed();
}

void ExportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  refresh();
  previewTimer_->start();
}

void ExportDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  previewTimer_->stop();
  withdrawQuestion();
  outcome_->clear();
  preview_->cancelPreview(); // nobody looks at it; an export goes on
}

void ExportDialog::stop() {
  if (running_) {
    jobs_->cancel();
  } else {
    preview_->stopOnUserRequest();
  }
}

void ExportDialog::changed() {
  withdrawQuestion();
  if (trajectory_ != nullptr) {
    preview_->requestPreview();
  }
}

void ExportDialog::formatChanged() {
  QStringList known;
  for (const ExportFormat& format : exportFormats()) {
    known << QString::fromUtf8(format.suffix.data());
  }
  proposed_->setSuffix(form_->suffix(), known);
  changed();
}

void ExportDialog::resetChoices(const QString& file) {
  form_->resetChoices();
  proposed_->reset(file);
  formatChanged();
  if (isVisible()) {
    refresh();
  }
}

void ExportDialog::proposeFile(const QString& file) {
  proposed_->propose(file);
}

std::filesystem::path ExportDialog::file() const {
  return file_->text().toStdString();
}

void ExportDialog::chooseFile() {
  const QString chosen = QFileDialog::getSaveFileName(this, tr("Export trajectory"), file_->text());
  if (!chosen.isEmpty()) {
    file_->setText(chosen);
    // The question was asked there, if there was one to ask; until that is known it is open.
    jobs_->checkFileExists(chosen.toStdString(), [this, asked = questions_](bool exists) {
      mayReplace_ = mayReplace_ || (exists && asked == questions_);
    });
  }
}

void ExportDialog::setRunning(bool running) {
  running_ = running;
  progress_->setVisible(running);
  cancel_->setVisible(running);
  preview_->setExporting(running);
  progress_->setValue(0);
  export_->setEnabled(!running);
  figure_->setEnabled(!running);
}

void ExportDialog::setSelectedRange(std::optional<std::pair<double, double>> seconds) {
  form_->setSelectedRange(seconds);
}

void ExportDialog::askToReplace(const QString& file) {
  question_->setText(tr("%1 exists already. Replace it?").arg(file));
  question_->show();
  export_->setText(tr("Replace"));
  mayReplace_ = true;
}

void ExportDialog::withdrawQuestion() {
  ++questions_;
  mayReplace_ = false;
  question_->hide();
  export_->setText(tr("Export"));
}

void ExportDialog::start() {
  ExportOptions chosen = form_->options();
  chosen.replacesExisting = mayReplace_;
  withdrawQuestion();
  startedAt_ = questions_;
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_()); // with what came since
  form_->setTrajectory(*trajectory_);
  preview_->cancelPendingRequest();
  outcome_->clear();
  setRunning(true);
  jobs_->run(trajectory_, chosen, file());
}

void ExportDialog::startFigure() {
  const QFileInfo file(file_->text());
  const QString proposed = file.dir().filePath(file.completeBaseName() + QStringLiteral(".svg"));
  const QString chosen =
      QFileDialog::getSaveFileName(this, tr("Save figure"), proposed, tr("Figures (*.svg *.pdf)"));
  if (chosen.isEmpty()) {
    return;
  }
  refresh();
  setRunning(true);
  const FigureTexts texts{figureTitle(trajectory_->header.entries), tr("time (s)").toStdString(),
                          tr("from above").toStdString()};
  const std::filesystem::path figure = chosen.toStdString();
  jobs_->run(
      [trajectory = trajectory_, options = form_->options(), texts, figure]() -> Status {
        const auto table = makeExportTable(*trajectory, options, {});
        return table ? writeTrajectoryFigure(*table, texts, figure)
                     : Status(tl::make_unexpected(table.error()));
      },
      figure);
}

void ExportDialog::showFinished(const ExportSummary& summary) {
  setRunning(false);
  if (!summary.existingFile.empty()) {
    const QString name = QString::fromStdString(summary.existingFile.string());
    if (startedAt_ == questions_) {
      askToReplace(name);
    } else { // something changed, or the dialog was closed: nobody sees the question, or it is moot
      reportFailed(tr("%1 exists already; nothing was written.").arg(name));
    }
    if (isVisible()) {
      preview_->requestPreview(); // the preview was stopped for it
    }
    return;
  }
  if (summary.isCanceled) {
    reportDone(tr("The export was canceled."));
    return;
  }
  reportDone(exportedText(summary), QString::fromStdString(summary.files.back().string()));
}

} // namespace dewpoint::ui
