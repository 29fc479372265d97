// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/exchange/exchange_dialog.h"

#include "ui/jobs/background_job.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace dewpoint::ui {
namespace {
constexpr const char* kPreviewed = "previewed"; ///< the text of a field that the preview is of
constexpr int kTypingPauseMs = 300;             ///< after which the preview follows what is typed
} // namespace

ExchangeDialog::ExchangeDialog(const QString& name, QWidget* parent)
    : QDialog(parent), fileLabel_(new QLabel(this)), choose_(new QPushButton(this)),
      accept_(new QPushButton(this)), file_(new QLineEdit(this)), form_(new QFormLayout),
      fileRow_(new QHBoxLayout), previewLabel_(new QLabel(this)),
      preview_(new QPlainTextEdit(this)), close_(new QPushButton(this)),
      job_(new BackgroundJob(this)), typingPause_(new QTimer(this)) {
  setObjectName(name);
  setModal(false);
  file_->setObjectName(name + QStringLiteral("File"));
  choose_->setObjectName(name + QStringLiteral("Choose"));
  accept_->setObjectName(name + QStringLiteral("Accept"));
  close_->setObjectName(name + QStringLiteral("Close"));
  preview_->setObjectName(name + QStringLiteral("Preview"));
  previewLabel_->setObjectName(name + QStringLiteral("PreviewTitle"));
  preview_->setReadOnly(true);
  preview_->setTabChangesFocus(true);
  preview_->setMinimumSize(460, 200);
  for (QPushButton* button : {choose_, close_}) {
    button->setAutoDefault(false); // Enter in a field is for the preview
  }
  accept_->setDefault(true);
  fileRow_->setSpacing(6);
  fileRow_->addWidget(file_, 1);
  fileRow_->addWidget(choose_);
  form_->setSpacing(8);
  form_->addRow(fileLabel_, fileRow_);
  fileLabel_->setBuddy(file_);
  previewLabel_->setBuddy(preview_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(accept_, QDialogButtonBox::AcceptRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] { performExchange(); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(8);
  column->addLayout(form_);
  column->addWidget(previewLabel_);
  column->addWidget(preview_, 1);
  column->addWidget(buttons);
}

void ExchangeDialog::finishLayout() {
  for (QLineEdit* line : findChildren<QLineEdit*>()) {
    // Leaving a field as it was is no news: the button would be disabled under the mouse.
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
      if (line->property(kPreviewed).toString() != line->text()) {
        refresh();
      }
    });
    connect(line, &QLineEdit::textEdited, typingPause_, qOverload<>(&QTimer::start));
  }
  typingPause_->setSingleShot(true);
  typingPause_->setInterval(kTypingPauseMs);
  connect(typingPause_, &QTimer::timeout, this, [this] {
    typing_ = true;
    refreshPreview();
  });
  connect(choose_, &QPushButton::clicked, this, [this] { chooseFile(); });
  connect(job_, &BackgroundJob::ended, this, [this] {
    if (std::exchange(rerunPreview_, false)) {
      start();
    }
  });
  for (QComboBox* choice : findChildren<QComboBox*>()) {
    connect(choice, &QComboBox::currentIndexChanged, this, &ExchangeDialog::refresh);
  }
  onRetranslate(this, [this] {
    file_->setAccessibleName(tr("File"));
    file_->setToolTip(tr("The file, or the folder with a file for each camera"));
    choose_->setText(tr("Choose…"));
    choose_->setAccessibleName(tr("Choose the file"));
    choose_->setToolTip(tr("Choose the file to read or write"));
    setShowsResult(showsResult_);
    preview_->setAccessibleName(previewLabel_->text());
    preview_->setPlaceholderText(
        tr("Choose a file. A preview of the result is shown here before anything changes."));
    close_->setText(tr("Close"));
    close_->setToolTip(tr("Close without changing anything"));
    retranslateFields();
    refresh();
  });
}

QComboBox* ExchangeDialog::addComboBox(const char* name) {
  auto* choice = new QComboBox(this);
  choice->setObjectName(objectName() + QLatin1String(name));
  makeNarrow(*choice);
  return choice;
}

QLabel* ExchangeDialog::addRow(QWidget* field) {
  auto* label = new QLabel(this);
  form_->addRow(label, field);
  label->setBuddy(field);
  return label;
}

void ExchangeDialog::addButton(QPushButton* button) {
  button->setAutoDefault(false);
  fileRow_->addWidget(button);
}

QString ExchangeDialog::file() const {
  return file_->text().trimmed();
}

void ExchangeDialog::setFile(const QString& file) {
  file_->setText(file);
  refresh();
}

void ExchangeDialog::proposeFile(const QString& file) {
  file_->setText(file);
}

void ExchangeDialog::refresh() {
  typing_ = false;
  refreshPreview();
}

void ExchangeDialog::refreshPreview() {
  typingPause_->stop();
  for (QLineEdit* line : findChildren<QLineEdit*>()) {
    line->setProperty(kPreviewed, line->text());
  }
  ready_ = false;
  accept_->setEnabled(false);
  if (job_->isRunning()) {
    rerunPreview_ = true;
  } else {
    start();
  }
}

void ExchangeDialog::start() {
  if (file().isEmpty()) {
    preview_->clear();
    return;
  }
  runTask(makePreview());
}

void ExchangeDialog::runTask(const Preview& task) {
  ready_ = false;
  accept_->setEnabled(false);
  job_->start([task](const BackgroundJob::Progress&) { return task(); });
}

void ExchangeDialog::showPreview(const QString& text, bool ready) {
  if (rerunPreview_) {
    return; // of answers that have changed since
  }
  setShowsResult(false);
  preview_->setPlainText(text);
  ready_ = ready;
  accept_->setEnabled(ready);
}

void ExchangeDialog::showResult(const QString& text) {
  showPreview(text, false);
  setShowsResult(!rerunPreview_);
}

void ExchangeDialog::setShowsResult(bool shows) {
  showsResult_ = shows;
  previewLabel_->setText(shows ? tr("Result") : tr("Preview"));
}

} // namespace dewpoint::ui
