// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_dialog.h"

#include "core/trajectory/export/export_catalog.h"
#include "ui/export/export_form.h"
#include "ui/export/export_outcome.h"
#include "ui/export/export_text.h"
#include "ui/export/trajectory_figure.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {

constexpr int kPreviewDelayMs = 150;
constexpr int kFollowMs = 2000;
constexpr std::size_t kMostToFollow = 20'000; ///< samples; to copy more takes noticeable time
constexpr int kSoonDoneMs = 500;              ///< less needs no button to stop it

} // namespace

ExportDialog::ExportDialog(std::function<Trajectory()> trajectory, QWidget* parent)
    : QDialog(parent), trajectorySource_(std::move(trajectory)), jobs_(new ExportJobs(this)),
      soon_(new QTimer(this)), follow_(new QTimer(this)), long_(new QTimer(this)) {
  setObjectName(QStringLiteral("exportDialog"));
  soon_->setSingleShot(true);
  soon_->setInterval(kPreviewDelayMs);
  follow_->setInterval(kFollowMs);
  long_->setSingleShot(true);
  long_->setInterval(kSoonDoneMs);
  makeFields();
  arrangeFields();
  onRetranslate(this, [this] { retranslateUi(); });
  connectFields();
  setRunning(false);
  proposeIn(QDir::homePath());
  resize(760, 620);
}

void ExportDialog::makeFields() {
  form_ = new ExportForm(this);
  preview_ = named(new QPlainTextEdit(this), "exportPreview");
  preview_->setReadOnly(true);
  preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
  preview_->setTabChangesFocus(true);
  preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  units_ = named(new QLabel(this), "exportUnits");
  units_->setWordWrap(true);
  size_ = named(new QLabel(this), "exportSize");
  size_->setWordWrap(true);
  old_ = named(new QLabel(this), "exportOldResults");
  old_->setWordWrap(true);
  old_->hide();
  outcome_ = new ExportOutcome(this);
  question_ = named(new QLabel(this), "exportQuestion");
  question_->setWordWrap(true);
  question_->hide();
  file_ = named(new QLineEdit(this), "exportFile");
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
  auto* right = new QVBoxLayout;
  right->setSpacing(8);
  right->addWidget(units_);
  right->addWidget(size_);
  right->addWidget(old_);
  right->addWidget(preview_, 1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(form_);
  columns->addLayout(right, 1);
  auto* place = new QHBoxLayout;
  place->setSpacing(8);
  place->addWidget(file_, 1);
  place->addWidget(browse_);
  // No accept role: Enter would press it.
  auto* box = new QDialogButtonBox(this);
  box->addButton(figure_, QDialogButtonBox::ActionRole);
  box->addButton(export_, QDialogButtonBox::ActionRole);
  box->addButton(close_, QDialogButtonBox::RejectRole);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(progress_, 1);
  buttons->addWidget(cancel_);
  buttons->addStretch(1);
  buttons->addWidget(box);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(16);
  layout->addLayout(columns, 1);
  layout->addLayout(place);
  layout->addWidget(question_);
  layout->addWidget(outcome_);
  layout->addLayout(buttons);
}

void ExportDialog::retranslateUi() {
  setWindowTitle(tr("Export trajectory"));
  form_->retranslateUi();
  preview_->setAccessibleName(tr("First lines of the file"));
  preview_->setToolTip(tr("First lines of the file"));
  units_->setAccessibleName(tr("Units and axes"));
  size_->setAccessibleName(tr("Size"));
  old_->setText(tr("Some of these results are of earlier settings."));
  outcome_->retranslateUi();
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("File to write"));
  browse_->setText(tr("Browse…"));
  browse_->setToolTip(tr("Choose the file to write"));
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the work under way; what is there already stays as it was"));
  figure_->setText(tr("Figure…"));
  figure_->setToolTip(tr("Write a figure of it as SVG or PDF: x, y, z over time and from above"));
  forgetQuestion(); // in the new language
  export_->setToolTip(tr("Write the file in the background"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close; an export that is under way goes on"));
  changed();
}

void ExportDialog::connectFields() {
  connect(soon_, &QTimer::timeout, this, [this] {
    previewing_ = true;
    long_->start();
    jobs_->preview(trajectory_, form_->options(), file());
  });
  connect(long_, &QTimer::timeout, cancel_, &QWidget::show);
  connect(form_, &ExportForm::formatChanged, this, &ExportDialog::formatChanged);
  connect(form_, &ExportForm::changed, this, &ExportDialog::changed);
  connect(follow_, &QTimer::timeout, this, &ExportDialog::follow);
  connect(file_, &QLineEdit::textChanged, this, &ExportDialog::forgetQuestion);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::askFile);
  connect(export_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(figure_, &QPushButton::clicked, this, &ExportDialog::startFigure);
  connect(cancel_, &QPushButton::clicked, this, &ExportDialog::stop);
  connect(jobs_, &ExportJobs::previewing, this, [this](int percent) {
    if (previewing_) {
      size_->setText(tr("Working on the preview: %1 %").arg(percent));
    }
  });
  connect(jobs_, &ExportJobs::previewReady, this, &ExportDialog::showPreview);
  connect(jobs_, &ExportJobs::previewFailed, this, [this](const QString& sentence) {
    endPreview();
    units_->clear();
    size_->setText(sentence);
    preview_->clear();
  });
  connect(jobs_, &ExportJobs::progressChanged, progress_, &QProgressBar::setValue);
  connect(jobs_, &ExportJobs::finished, this, &ExportDialog::showFinished);
  connect(jobs_, &ExportJobs::failed, this, [this](const QString& sentence) {
    setRunning(false);
    reportFailed(sentence);
  });
}

void ExportDialog::reportDone(const QString& sentence, const QString& file) {
  if (isVisible()) {
    outcome_->show(sentence, file);
  }
  Q_EMIT done(sentence);
}

void ExportDialog::reportFailed(const QString& sentence) {
  if (isVisible()) {
    outcome_->show(sentence);
  }
  Q_EMIT failed(sentence);
}

void ExportDialog::setHasOldResults(bool has) {
  old_->setVisible(has);
}

void ExportDialog::follow() {
  if (running_ || previewing_ || soon_->isActive() || !form_->isLive() ||
      trajectory_->samples.size() > kMostToFollow) {
    return;
  }
  auto now = trajectorySource_();
  if (now.samples.size() != trajectory_->samples.size()) {
    trajectory_ = std::make_shared<const Trajectory>(std::move(now));
    form_->setTargetsOf(*trajectory_);
    soon_->start();
  }
}

void ExportDialog::refresh() {
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_());
  form_->setTargetsOf(*trajectory_);
  changed();
}

void ExportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  refresh();
  follow_->start();
}

void ExportDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  soon_->stop(); // nobody looks at it; an export goes on
  follow_->stop();
  forgetQuestion();
  outcome_->clear();
  jobs_->stopPreview();
  endPreview();
}

void ExportDialog::endPreview() {
  previewing_ = false;
  long_->stop();
  cancel_->setVisible(running_);
}

void ExportDialog::stop() {
  if (running_) {
    jobs_->cancel();
    return;
  }
  jobs_->stopPreview();
  endPreview();
  units_->clear();
  preview_->clear();
  size_->setText(tr("The preview was stopped. The next change begins it anew."));
}

void ExportDialog::changed() {
  forgetQuestion();
  if (trajectory_ != nullptr) {
    soon_->start();
  }
}

void ExportDialog::formatChanged() {
  QString name = file_->text();
  for (const ExportFormat& format : exportFormats()) {
    const QString old = QString::fromUtf8(format.suffix.data());
    if (name.endsWith(old)) {
      name.chop(old.size());
      break;
    }
  }
  file_->setText(name + form_->suffix());
  changed();
}

void ExportDialog::startAnew(const QString& folder) {
  form_->startAnew();
  proposeIn(folder);
  if (isVisible()) {
    refresh();
  }
}

void ExportDialog::proposeIn(const QString& folder) {
  file_->setText(QDir(folder).filePath(QStringLiteral("trajectory")));
  formatChanged();
}

std::filesystem::path ExportDialog::file() const {
  return file_->text().toStdString();
}

void ExportDialog::askFile() {
  const QString chosen = QFileDialog::getSaveFileName(this, tr("Export trajectory"), file_->text());
  if (!chosen.isEmpty()) {
    file_->setText(chosen);
    // The question was asked there, if there was one to ask; until that is known it is open.
    jobs_->find(chosen.toStdString(), [this, asked = questions_](bool exists) {
      mayReplace_ = mayReplace_ || (exists && asked == questions_);
    });
  }
}

void ExportDialog::setRunning(bool running) {
  running_ = running;
  progress_->setVisible(running);
  cancel_->setVisible(running);
  if (running && previewing_) {
    size_->clear(); // the export stops it
  } else if (previewing_) {
    soon_->start();
  }
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

void ExportDialog::forgetQuestion() {
  ++questions_;
  mayReplace_ = false;
  question_->hide();
  export_->setText(tr("Export"));
}

void ExportDialog::start() {
  ExportOptions chosen = form_->options();
  chosen.replaces = mayReplace_;
  forgetQuestion();
  startedAt_ = questions_;
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_()); // with what came since
  form_->setTargetsOf(*trajectory_);
  soon_->stop();
  outcome_->clear();
  setRunning(true);
  jobs_->run(trajectory_, chosen, file());
}

void ExportDialog::startFigure() {
  const QString proposed = QFileInfo(file_->text()).path() + QStringLiteral("/trajectory.svg");
  const QString chosen = QFileDialog::getSaveFileName(this, tr("Write a figure"), proposed,
                                                      tr("Figures (*.svg *.pdf)"));
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

void ExportDialog::showPreview(const ExportPreview& preview) {
  endPreview();
  units_->setText(exportUnitsText(preview));
  size_->setText(exportSizeText(preview));
  preview_->setPlainText(QString::fromStdString(preview.text));
}

void ExportDialog::showFinished(const ExportSummary& summary) {
  setRunning(false);
  if (!summary.occupied.empty()) {
    const QString name = QString::fromStdString(summary.occupied.string());
    if (startedAt_ == questions_) {
      askToReplace(name);
    } else { // something changed, or the dialog was closed: nobody sees the question, or it is moot
      reportFailed(tr("%1 exists already; nothing was written.").arg(name));
    }
    if (isVisible()) {
      soon_->start(); // the preview was stopped for it
    }
    return;
  }
  if (summary.canceled) {
    reportDone(tr("The export was canceled."));
    return;
  }
  reportDone(exportedText(summary), QString::fromStdString(summary.files.back().string()));
}

} // namespace dewpoint::ui
