// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_outcome.h"

#include "ui/widgets/named.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QUrl>

namespace dewpoint::ui {

ExportOutcome::ExportOutcome(QWidget* parent)
    : QWidget(parent), sentence_(named(new QLabel(this), "exportOutcome")),
      folder_(named(new QPushButton(this), "exportShowFolder")) {
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  folder_->setAutoDefault(false);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(sentence_, 1);
  layout->addWidget(folder_, 0, Qt::AlignTop);
  connect(folder_, &QPushButton::clicked, this, &ExportOutcome::openFolder);
  clear();
}

void ExportOutcome::showResult(const QString& sentence, const QString& file) {
  file_ = file;
  sentence_->setText(sentence);
  folder_->setVisible(!file.isEmpty());
  setVisible(true);
}

void ExportOutcome::clear() {
  hide();
  sentence_->clear();
}

void ExportOutcome::retranslateUi() {
  folder_->setText(tr("Show in folder"));
  folder_->setToolTip(tr("Open the folder of the file that was written"));
  clear(); // in the language of then
}

void ExportOutcome::openFolder() {
  const QString folder = QFileInfo(file_).absolutePath();
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
    sentence_->setText(tr("No file manager was found. The path of the file is %1.").arg(file_));
  }
}

} // namespace dewpoint::ui
