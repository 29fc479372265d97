// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_dialog.h"

#include "ui/export/export_text.h"
#include "ui/export/trajectory_figure.h"
#include "ui/text/retranslation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr int kPreviewDelayMs = 150;
constexpr int kFollowMs = 2000;
constexpr std::size_t kMostToFollow = 20'000; ///< samples; to copy more takes noticeable time
constexpr int kSoonDoneMs = 500;              ///< less needs no button to stop it

/// What a figure is of: the project and the method.
QString titleOf(const Trajectory& trajectory) {
  QStringList parts;
  for (const auto& [key, value] : trajectory.header.entries) {
    if ((key == "project" || key == "method") && !value.empty()) {
      parts << QString::fromStdString(value);
    }
  }
  return parts.join(QStringLiteral(" · "));
}

} // namespace

ExportDialog::ExportDialog(std::function<Trajectory()> trajectory, QWidget* parent)
    : QDialog(parent), trajectorySource_(std::move(trajectory)), worker_(new ExportWorker(this)),
      soon_(new QTimer(this)), follow_(new QTimer(this)), long_(new QTimer(this)) {
  setObjectName(QStringLiteral("exportDialog"));
  soon_->setSingleShot(true);
  soon_->setInterval(kPreviewDelayMs);
  follow_->setInterval(kFollowMs);
  long_->setSingleShot(true);
  long_->setInterval(kSoonDoneMs);
  makeFields();
  arrangeFields();
  onRetranslate(this, [this] { retranslate(); });
  connectFields();
  setRunning(false);
  proposeIn(QDir::homePath());
  resize(760, 620);
}

void ExportDialog::connectFields() {
  connect(soon_, &QTimer::timeout, this, [this] {
    previewing_ = true;
    long_->start();
    worker_->preview(trajectory_, options(), file());
  });
  connect(long_, &QTimer::timeout, cancel_, &QWidget::show);
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::formatChanged);
  for (QComboBox* box : {estimates_, gaps_, axes_, unit_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::changed);
  }
  for (QDoubleSpinBox* spin : {from_, to_, rate_, longestGap_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, &ExportDialog::changed);
  }
  connect(follow_, &QTimer::timeout, this, &ExportDialog::follow);
  connect(file_, &QLineEdit::textChanged, this, &ExportDialog::forgetQuestion);
  connect(header_, &QCheckBox::toggled, this, &ExportDialog::changed);
  connect(targets_, &QListWidget::itemChanged, this, &ExportDialog::changed);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::askFile);
  connect(export_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(figure_, &QPushButton::clicked, this, &ExportDialog::startFigure);
  connect(cancel_, &QPushButton::clicked, this, &ExportDialog::stop);
  connect(worker_, &ExportWorker::previewing, this, [this](int percent) {
    if (previewing_) {
      size_->setText(tr("Working on the preview: %1 %").arg(percent));
    }
  });
  connect(worker_, &ExportWorker::previewReady, this, &ExportDialog::showPreview);
  connect(worker_, &ExportWorker::previewFailed, this, [this](const QString& sentence) {
    endPreview();
    units_->clear();
    size_->setText(sentence);
    preview_->clear();
  });
  connect(worker_, &ExportWorker::progressChanged, progress_, &QProgressBar::setValue);
  connect(worker_, &ExportWorker::finished, this, &ExportDialog::showFinished);
  connect(worker_, &ExportWorker::failed, this, [this](const QString& sentence) {
    setRunning(false);
    Q_EMIT failed(sentence);
  });
}

void ExportDialog::fillTargets() {
  QStringList names;
  for (const TrajectorySample& sample : trajectory_->samples) {
    const QString name = QString::fromStdString(sample.target);
    if (!names.contains(name)) {
      names << name;
    }
  }
  QStringList shown;
  for (int i = 0; i < targets_->count(); ++i) {
    shown << targets_->item(i)->text();
  }
  if (names == shown) {
    return;
  }
  const QSignalBlocker quiet(targets_);
  targets_->clear();
  for (const QString& name : names) {
    auto* item = new QListWidgetItem(name, targets_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
}

void ExportDialog::follow() {
  const bool live = estimates_->currentIndex() == 0;
  if (running_ || previewing_ || soon_->isActive() || !live ||
      trajectory_->samples.size() > kMostToFollow) {
    return;
  }
  auto now = trajectorySource_();
  if (now.samples.size() != trajectory_->samples.size()) {
    trajectory_ = std::make_shared<const Trajectory>(std::move(now));
    fillTargets();
    soon_->start();
  }
}

void ExportDialog::refresh() {
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_());
  fillTargets();
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
  worker_->stopPreview();
  endPreview();
}

void ExportDialog::endPreview() {
  previewing_ = false;
  long_->stop();
  cancel_->setVisible(running_);
}

void ExportDialog::stop() {
  if (running_) {
    worker_->cancel();
    return;
  }
  worker_->stopPreview();
  endPreview();
  units_->clear();
  preview_->clear();
  size_->setText(tr("The preview was stopped. The next change begins it anew."));
}

void ExportDialog::changed() {
  forgetQuestion();
  longestGap_->setEnabled(gaps_->currentIndex() == 1 || estimates_->currentIndex() == 1);
  if (trajectory_ != nullptr) {
    soon_->start();
  }
}

void ExportDialog::formatChanged() {
  const auto formats = exportFormats();
  const QString suffix = QString::fromUtf8(
      formats[static_cast<std::size_t>(std::max(0, format_->currentIndex()))].suffix.data());
  QString name = file_->text();
  for (const ExportFormat& format : formats) {
    const QString old = QString::fromUtf8(format.suffix.data());
    if (name.endsWith(old)) {
      name.chop(old.size());
      break;
    }
  }
  file_->setText(name + suffix);
  changed();
}

void ExportDialog::startAnew(const QString& folder) {
  for (QDoubleSpinBox* spin : {from_, to_, rate_}) {
    spin->setValue(spin->minimum());
  }
  longestGap_->setValue(ExportOptions().longestGap);
  for (QComboBox* box : {estimates_, gaps_, axes_, unit_}) {
    box->setCurrentIndex(0);
  }
  given_ = {from_->value(), to_->value()};
  proposeIn(folder);
  if (isVisible()) {
    refresh();
  }
}

void ExportDialog::proposeIn(const QString& folder) {
  file_->setText(QDir(folder).filePath(QStringLiteral("trajectory")));
  formatChanged();
}

ExportOptions ExportDialog::options() const {
  ExportOptions options;
  options.format = exportFormats()[static_cast<std::size_t>(format_->currentIndex())].id;
  for (int i = 0; i < targets_->count(); ++i) {
    if (targets_->item(i)->checkState() == Qt::Checked) {
      options.targets.push_back(targets_->item(i)->text().toStdString());
    }
  }
  if (from_->value() >= 0.0) {
    options.from = SpanEnd{from_->value(), false};
  }
  if (to_->value() >= 0.0) {
    options.to = SpanEnd{to_->value(), false};
  }
  if (rate_->value() > 0.0) {
    options.rate = rate_->value();
  }
  options.gaps = gaps_->currentIndex() == 1 ? GapRule::Fill : GapRule::Leave;
  options.longestGap = longestGap_->value();
  if (axes_->currentIndex() > 0) {
    options.axes = axes_->currentIndex() == 1 ? WorldAxes::ZUp : WorldAxes::YUp;
  }
  if (unit_->currentIndex() > 0) {
    options.unit = unit_->currentIndex() == 1 ? LengthUnit::Meter : LengthUnit::Millimeter;
  }
  options.header = header_->isChecked();
  options.smooth = estimates_->currentIndex() == 1;
  options.date = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  return options;
}

std::filesystem::path ExportDialog::file() const {
  return file_->text().toStdString();
}

void ExportDialog::askFile() {
  const QString chosen = QFileDialog::getSaveFileName(this, tr("Export trajectory"), file_->text());
  if (!chosen.isEmpty()) {
    file_->setText(chosen);
    mayReplace_ = QFileInfo::exists(chosen); // the question was asked there
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

void ExportDialog::setSpan(std::optional<std::pair<double, double>> seconds) {
  const std::pair<double, double> all(from_->minimum(), to_->minimum());
  if (!seconds && std::pair(from_->value(), to_->value()) != given_) {
    return; // typed by hand since
  }
  // Outwards to what the fields can show, or rounding would lose the last frame.
  const double steps = std::pow(10.0, from_->decimals());
  from_->setValue(seconds ? std::floor(seconds->first * steps) / steps : all.first);
  to_->setValue(seconds ? std::ceil(seconds->second * steps) / steps : all.second);
  given_ = seconds ? std::pair(from_->value(), to_->value()) : all;
}

void ExportDialog::askToReplace(const QString& file) {
  question_->setText(tr("%1 exists already. Replace it?").arg(file));
  question_->show();
  export_->setText(tr("Replace"));
  mayReplace_ = true;
}

void ExportDialog::forgetQuestion() {
  mayReplace_ = false;
  question_->hide();
  export_->setText(tr("Export"));
}

void ExportDialog::start() {
  if (!mayReplace_ && QFileInfo::exists(file_->text())) {
    askToReplace(file_->text());
    return;
  }
  ExportOptions chosen = options();
  chosen.replaces = mayReplace_;
  forgetQuestion();
  trajectory_ = std::make_shared<const Trajectory>(trajectorySource_()); // with what came since
  fillTargets();
  soon_->stop();
  setRunning(true);
  worker_->run(trajectory_, chosen, file());
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
  const FigureWords words{titleOf(*trajectory_), tr("time (s)"), tr("from above")};
  const std::filesystem::path figure = chosen.toStdString();
  worker_->run(
      [trajectory = trajectory_, options = options(), words, figure]() -> Status {
        const auto table = makeExportTable(*trajectory, options, {});
        return table ? writeTrajectoryFigure(*table, words, figure)
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
  if (!summary.occupied.empty()) { // one of several files
    askToReplace(QString::fromStdString(summary.occupied.string()));
    return;
  }
  if (summary.cancelled) {
    Q_EMIT done(tr("The export was cancelled."));
    return;
  }
  const QString name = QString::fromStdString(summary.files.back().string());
  if (summary.rows == 0) {
    Q_EMIT done(tr("Wrote the figure %1.").arg(name));
  } else if (summary.files.size() > 1) {
    Q_EMIT done(tr("Exported %1 rows to %2 files; the last is %3.")
                    .arg(summary.rows)
                    .arg(summary.files.size())
                    .arg(name));
  } else {
    Q_EMIT done(tr("Exported %1 rows to %2.").arg(summary.rows).arg(name));
  }
}

} // namespace dewpoint::ui
