// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/exchange/calibration_export.h"

#include "core/calibration/formats/format_catalog.h"
#include "core/setup/new_project/new_project.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace dewpoint::ui {
namespace {

/// Removes the ending of any format of calibrations.
QString withoutEnding(const QString& file) {
  qsizetype longest = 0;
  for (const CalibrationFormat& format : calibrationFormats()) {
    const QLatin1String ending(format.extension);
    if (file.endsWith(ending, Qt::CaseInsensitive)) {
      longest = std::max(longest, qsizetype(ending.size()));
    }
  }
  return file.chopped(longest);
}

constexpr double kLeastLossPx = 0.01; ///< less is not worth a number: no click is that accurate

bool losesAccuracy(const CameraDifference& camera) {
  return !(camera.maxDifferencePx <= kLeastLossPx) || camera.unseenDirectionCount > 0;
}

} // namespace

CalibrationExportDialog::CalibrationExportDialog(Document& document, QWidget* parent)
    : ExchangeDialog(QStringLiteral("calibrationExport"), parent), document_(document),
      format_(addComboBox("Format")), unit_(addComboBox("Unit")) {
  formatLabel_ = addRow(format_);
  unitLabel_ = addRow(unit_);
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write != nullptr) {
      format_->addItem(QString::fromUtf8(format.title), QLatin1String(format.name));
    }
  }
  connect(format_, &QComboBox::currentIndexChanged, this, &CalibrationExportDialog::formatChanged);
  connect(&document_, &Document::projectReplaced, this, &QDialog::close);
  connect(&document_, &Document::calibrationChanged, this, [this] {
    if (isVisible()) {
      refresh();
    }
  });
  proposeFile(proposedFile());
  finishLayout();
}

const CalibrationFormat& CalibrationExportDialog::format() const {
  return **findCalibrationFormat(format_->currentData().toString().toStdString());
}

bool CalibrationExportDialog::isFolder() const {
  const FileLayout layout = format().layout;
  return layout == FileLayout::CameraPair ||
         (layout == FileLayout::FilePerCamera && document_.project().cameras.size() > 1);
}

void CalibrationExportDialog::formatChanged() {
  unit_->setEnabled(!format().metersPerUnit.has_value());
  if (!file().isEmpty()) {
    // The same place, with the ending of the format.
    setFile(withoutEnding(file()) + ending());
  }
}

QString CalibrationExportDialog::ending() const {
  return isFolder() ? QString() : QString::fromLatin1(format().extension);
}

QString CalibrationExportDialog::proposedFile() const {
  const Project& project = document_.project();
  // Named like the project, beside its file, or where the project would be saved.
  const std::filesystem::path saved = proposedProjectFile(project);
  const std::filesystem::path folder =
      project.file.empty() ? saved.parent_path() : project.file.parent_path();
  const QString start =
      folder.empty() ? Preferences().lastFolder() : QString::fromStdString(folder.string());
  const QDir place = start.isEmpty() ? QDir::home() : QDir(start);
  return place.absoluteFilePath(QString::fromStdString(saved.stem().string()) +
                                QStringLiteral("-calibration") + ending());
}

void CalibrationExportDialog::chooseFile() {
  const QString proposed = file().isEmpty() ? proposedFile() : file();
  const QString chosen =
      isFolder() ? QFileDialog::getExistingDirectory(this, tr("Choose a folder"),
                                                     QFileInfo(proposed).path())
                 : QFileDialog::getSaveFileName(this, tr("Export the calibration"), proposed,
                                                QStringLiteral("%1 (*%2)")
                                                    .arg(QString::fromUtf8(format().title),
                                                         QLatin1String(format().extension)));
  if (!chosen.isEmpty()) {
    setFile(chosen);
  }
}

void CalibrationExportDialog::retranslateFields() {
  setWindowTitle(tr("Export the calibration"));
  fileLabel_->setText(tr("File"));
  accept_->setText(tr("Export"));
  accept_->setToolTip(tr("Write the file; an existing file is replaced"));
  formatLabel_->setText(tr("Format"));
  format_->setAccessibleName(tr("Format"));
  format_->setToolTip(tr("The program that will read the file"));
  unitLabel_->setText(tr("Unit"));
  unit_->setAccessibleName(tr("Unit"));
  unit_->setToolTip(tr("Unit of lengths, if the format does not define it"));
  {
    const QSignalBlocker quiet(unit_);
    const int chosen = std::max(0, unit_->currentIndex());
    unit_->clear();
    unit_->addItem(tr("default of the format"));
    unit_->addItem(tr("meters"), QStringLiteral("m"));
    unit_->addItem(tr("millimeters"), QStringLiteral("mm"));
    unit_->addItem(tr("centimeters"), QStringLiteral("cm"));
    unit_->setCurrentIndex(chosen);
    unit_->setEnabled(!format().metersPerUnit.has_value());
  }
}

CalibrationOutput CalibrationExportDialog::target() const {
  CalibrationOutput target;
  target.path = file().toStdString();
  target.format = format().name;
  target.metersPerUnit = unit_->isEnabled()
                             ? parseLengthUnit(unit_->currentData().toString().toStdString())
                             : std::nullopt;
  target.replacesExisting = true;
  return target;
}

QString CalibrationExportDialog::textOf(const CalibrationConversion& conversion,
                                        const QString& replaced) const {
  QStringList lines;
  for (const std::string& decision : conversion.decisions) {
    lines << QString::fromStdString(decision);
  }
  lines << QString();
  if (std::ranges::none_of(conversion.cameraDifferences, losesAccuracy)) {
    lines << tr("No accuracy is lost: points are projected to the same pixels as before.");
  }
  for (std::size_t k = 0; k < conversion.cameraDifferences.size(); ++k) {
    const CameraDifference& camera = conversion.cameraDifferences[k];
    const QString name = cameraName(camera.camera, k);
    if (!(camera.maxDifferencePx <= kLeastLossPx)) {
      lines << (camera.isRefitted
                    ? tr("%1: with the exported calibration, projected points move by at most %2, "
                         "because the format cannot store this lens model and the lens was fitted "
                         "again")
                    : tr("%1: with the exported calibration, projected points move by at most %2"))
                   .arg(name, pixelDifferenceText(camera.maxDifferencePx));
    }
    if (camera.unseenDirectionCount > 0) {
      lines << tr("%1: with the exported lens, %2 of 81 tested directions can no longer be "
                  "projected into the image")
                   .arg(name)
                   .arg(camera.unseenDirectionCount);
    }
  }
  if (!replaced.isEmpty()) {
    lines << tr("%1 exists and will be replaced.").arg(replaced);
  }
  return lines.join(QLatin1Char('\n'));
}

ExchangeDialog::Preview CalibrationExportDialog::makePreview() {
  return [this, project = document_.project(), target = target(),
          file = isFolder() ? QString() : file()] {
    const auto outcome =
        std::make_shared<Result<CalibrationConversion>>(previewExport(project, target));
    const QString replaced = !file.isEmpty() && QFileInfo::exists(file) ? file : QString();
    return [this, outcome, replaced] { applyResult(*outcome, replaced); };
  };
}

void CalibrationExportDialog::applyResult(const Result<CalibrationConversion>& outcome,
                                          const QString& replaced) {
  if (outcome) {
    showPreview(textOf(*outcome, replaced), true);
  } else {
    const QString sentence = errorText(importProblem(outcome.error()).error);
    showPreview(QStringLiteral("⚠ ") + sentence, false);
    if (!isTyping()) {
      Q_EMIT failed(sentence);
    }
  }
}

void CalibrationExportDialog::performExchange() {
  if (!isReady()) {
    return;
  }
  runTask([this, project = document_.project(), target = target()] {
    const auto written =
        std::make_shared<Result<CalibrationConversion>>(exportCalibration(project, target));
    return [this, written] { finish(*written); };
  });
}

void CalibrationExportDialog::finish(const Result<CalibrationConversion>& written) {
  if (!written) {
    Q_EMIT failed(errorText(importProblem(written.error()).error));
    refresh();
    return;
  }
  QStringList files;
  for (const auto& one : written->writtenFiles) {
    files << QString::fromStdString(one.string());
  }
  const QString sentence = tr("Saved %1.").arg(files.join(QStringLiteral(", ")));
  showResult(sentence); // until an answer changes: there is nothing else to write
  Q_EMIT completed(sentence);
}

} // namespace dewpoint::ui
