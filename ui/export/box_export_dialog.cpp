// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/box_export_dialog.h"

#include "ui/export/export_form.h"
#include "ui/jobs/background_job.h"
#include "ui/preferences/preferences.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr std::size_t kPreviewRows = 200;

} // namespace

BoxExportDialog::BoxExportDialog(std::function<BoxTrack()> boxes, QWidget* parent)
    : QDialog(parent), boxes_(std::move(boxes)), job_(new BackgroundJob(this)),
      description_(new QLabel(this)), preview_(new QPlainTextEdit(this)),
      notes_(new QCheckBox(this)), folderLabel_(new QLabel(this)), folder_(new QLineEdit(this)),
      browse_(new QPushButton(this)), close_(new QPushButton(this)), export_(new QPushButton(this)),
      question_(new QLabel(this)) {
  setObjectName(QStringLiteral("boxExportDialog"));
  preview_->setObjectName(QStringLiteral("boxExportPreview"));
  folder_->setObjectName(QStringLiteral("boxExportFolder"));
  browse_->setObjectName(QStringLiteral("boxExportBrowse"));
  close_->setObjectName(QStringLiteral("boxExportClose"));
  export_->setObjectName(QStringLiteral("boxExportExport"));
  question_->setObjectName(QStringLiteral("boxExportQuestion"));
  question_->setWordWrap(true);
  description_->setWordWrap(true);
  preview_->setReadOnly(true);
  preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
  preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  preview_->setTabChangesFocus(true);
  notes_->setObjectName(QStringLiteral("boxExportNotes"));
  resetFolder(QDir::homePath());
  folderLabel_->setBuddy(folder_);
  export_->setDefault(true);
  auto* row = new QHBoxLayout;
  row->addWidget(folderLabel_);
  row->addWidget(folder_, 1);
  row->addWidget(browse_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(export_, QDialogButtonBox::AcceptRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  column->addWidget(description_);
  column->addWidget(preview_, 1);
  column->addWidget(notes_);
  column->addLayout(row);
  column->addWidget(question_);
  column->addWidget(buttons);
  resize(720, 460);
  connect(browse_, &QPushButton::clicked, this, &BoxExportDialog::chooseFolder);
  connect(buttons, &QDialogButtonBox::accepted, this, &BoxExportDialog::start);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(folder_, &QLineEdit::textChanged, this, [this] { askToReplace(false); });
  connect(notes_, &QCheckBox::toggled, this, [this](bool checked) {
    Preferences().setExportsNotes(checked);
    askToReplace(false);
    showFirstLines();
  });
  connect(job_, &BackgroundJob::ended, this, [this] { export_->setEnabled(true); });
  onRetranslate(this, [this] { retranslateUi(); });
}

void BoxExportDialog::retranslateUi() {
  setWindowTitle(tr("Export boxes"));
  description_->setText(
      tr("Two files are written. In boxes.csv, each row has the box of one target in one frame, "
         "its center, its similarity, and whether the target was seen or hidden. The file "
         "boxes_mot.txt has the format of the MOT challenge. All lengths are in pixels."));
  preview_->setAccessibleName(tr("First lines of boxes.csv"));
  notes_->setText(ExportForm::notesText());
  notes_->setToolTip(ExportForm::notesHint());
  folderLabel_->setText(tr("Folder"));
  folder_->setToolTip(tr("Folder for both files; it is created if it does not exist"));
  browse_->setText(tr("Choose…"));
  browse_->setToolTip(tr("Choose the folder of the files"));
  close_->setText(tr("Close"));
  askToReplace(false);
  export_->setToolTip(tr("Write both files (Enter)"));
}

void BoxExportDialog::proposeFolder(const QString& folder) {
  if (folder_->text() == proposed_) {
    resetFolder(folder);
  }
}

void BoxExportDialog::resetFolder(const QString& folder) {
  proposed_ = QDir::toNativeSeparators(folder);
  folder_->setText(proposed_);
}

void BoxExportDialog::askToReplace(bool ask) {
  mayReplace_ = ask;
  question_->setVisible(ask);
  question_->setText(tr("The folder already contains exported boxes. Replace them?"));
  export_->setText(ask ? tr("Replace") : tr("Export"));
}

void BoxExportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  askToReplace(false);
  const QSignalBlocker quiet(notes_);
  notes_->setChecked(Preferences().exportsNotes());
  showFirstLines();
}

void BoxExportDialog::showFirstLines() {
  BoxTrack track = boxes_();
  track.samples.resize(std::min(track.samples.size(), kPreviewRows));
  preview_->setPlainText(QString::fromStdString(boxCsv(track, chosenNotes())));
}

CsvNotes BoxExportDialog::chosenNotes() const {
  return notes_->isChecked() ? CsvNotes::Written : CsvNotes::LeftOut;
}

void BoxExportDialog::chooseFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the boxes"), folder_->text());
  if (!folder.isEmpty()) {
    folder_->setText(folder);
  }
}

std::filesystem::path BoxExportDialog::chosenFolder() const {
  return folder_->text().trimmed().toStdString();
}

void BoxExportDialog::start() {
  const bool replaces = mayReplace_;
  askToReplace(false);
  auto track = std::make_shared<const BoxTrack>(boxes_());
  const bool begun = job_->start([this, folder = chosenFolder(), track, replaces,
                                  notes = chosenNotes()](const BackgroundJob::Progress&) {
    std::error_code problem;
    for (const char* name : {"boxes.csv", "boxes_mot.txt"}) {
      if (!replaces && std::filesystem::exists(folder / name, problem)) {
        return std::function<void()>([this, folder, name] { askAbout(folder, name); });
      }
    }
    std::filesystem::create_directories(folder, problem);
    const Status written =
        problem ? failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message())
                : writeBoxTrack(*track, folder, notes);
    return std::function<void()>([this, folder, written] {
      const QString place = QString::fromStdString(folder.string());
      if (written) {
        Q_EMIT fileWritten(QDir(place).filePath(QStringLiteral("boxes.csv")));
        Q_EMIT completed(tr("Saved boxes.csv and boxes_mot.txt in %1.").arg(place));
      } else {
        Q_EMIT failed(errorText(written.error()));
      }
    });
  });
  export_->setEnabled(!begun && export_->isEnabled());
}

void BoxExportDialog::askAbout(const std::filesystem::path& folder, const char* name) {
  if (isVisible() && chosenFolder() == folder) {
    askToReplace(true);
  } else { // it was closed, or another folder was chosen
    const QString file = QString::fromStdString((folder / name).string());
    Q_EMIT failed(tr("%1 exists already; nothing was written.").arg(file));
  }
}

} // namespace dewpoint::ui
