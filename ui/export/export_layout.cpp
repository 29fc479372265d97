// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_layout.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace dewpoint::ui {
namespace {

constexpr int kBetweenFields = 8;
constexpr int kBetweenRows = 16;

} // namespace

void arrangeExportDialog(QDialog& dialog, QLayout* content, const ExportDialogParts& parts) {
  auto* place = new QHBoxLayout;
  place->setSpacing(kBetweenFields);
  place->addWidget(parts.fileField, 1);
  place->addWidget(parts.browseButton);
  auto* box = new QDialogButtonBox(&dialog); // no accept role: Enter would press it
  for (QPushButton* action : parts.actionButtons) {
    box->addButton(action, QDialogButtonBox::ActionRole);
  }
  box->addButton(parts.closeButton, QDialogButtonBox::RejectRole);
  QObject::connect(box, &QDialogButtonBox::rejected, &dialog, &QDialog::close);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kBetweenFields);
  buttons->addWidget(parts.progressBar, 1);
  buttons->addWidget(parts.cancelButton);
  buttons->addStretch(1);
  buttons->addWidget(box);
  auto* layout = new QVBoxLayout(&dialog);
  layout->setContentsMargins(kBetweenRows, kBetweenRows, kBetweenRows, kBetweenRows);
  layout->setSpacing(kBetweenRows);
  layout->addLayout(content, 1);
  layout->addLayout(place);
  layout->addWidget(parts.question);
  layout->addWidget(parts.outcome);
  layout->addLayout(buttons);
}

} // namespace dewpoint::ui
