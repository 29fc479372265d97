// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording/take_dialog.h"

#include "core/session/take/take_folder.h"
#include "core/session/take/take_recorder.h"
#include "ui/text/retranslation.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QVBoxLayout>

namespace dewpoint::ui {

TakeDialog::TakeDialog(const TakeDetails& details, bool exists, QWidget* parent)
    : QDialog(parent), exists_(exists), numberLabel_(new QLabel(this)), number_(new QSpinBox(this)),
      notesLabel_(new QLabel(this)), notes_(new QPlainTextEdit(details.notes, this)),
      preRollLabel_(new QLabel(this)), preRoll_(new QSpinBox(this)) {
  setObjectName(QStringLiteral("takeDialog"));
  number_->setObjectName(QStringLiteral("takeNumber"));
  number_->setRange(0, kHighestTakeNumber);
  number_->setGroupSeparatorShown(false);
  number_->setValue(details.takeNumber);
  number_->setEnabled(!exists_);
  notes_->setObjectName(QStringLiteral("takeNotes"));
  notes_->setTabChangesFocus(true);
  preRoll_->setObjectName(QStringLiteral("takePreRoll"));
  preRoll_->setRange(0, static_cast<int>(TakeRecorder::kMaxPreRollSeconds));
  preRoll_->setValue(details.preRollSeconds);
  preRollLabel_->setVisible(!exists_);
  preRoll_->setVisible(!exists_);
  numberLabel_->setBuddy(number_);
  preRollLabel_->setBuddy(preRoll_);
  notesLabel_->setBuddy(notes_);
  auto* form = new QFormLayout;
  form->setSpacing(8);
  form->addRow(numberLabel_, number_);
  form->addRow(notesLabel_, notes_);
  form->addRow(preRollLabel_, preRoll_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  for (QAbstractButton* button : buttons->buttons()) {
    button->setIcon({}); // as in the other dialogs
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(buttons);
  onRetranslate(this, [this] { retranslateUi(); });
  notes_->setFocus();
}

TakeDetails TakeDialog::details() const {
  return {number_->value(), notes_->toPlainText(), preRoll_->value()};
}

void TakeDialog::retranslateUi() {
  setWindowTitle(exists_ ? tr("Take %1").arg(number_->value()) : tr("Next take"));
  numberLabel_->setText(tr("Number"));
  number_->setSpecialValueText(tr("next free number"));
  number_->setToolTip(
      tr("Number of the take and of its folder. The number increases by itself with each take."));
  notesLabel_->setText(tr("Notes"));
  preRollLabel_->setText(tr("Pre-roll"));
  preRoll_->setSpecialValueText(tr("off"));
  preRoll_->setSuffix(tr(" s"));
  preRoll_->setToolTip(
      tr("How many seconds before the start are recorded as well. For this, the last "
         "images of all cameras are kept in memory, up to 512 MB in total."));
  notes_->setPlaceholderText(tr("Text that is saved with the take"));
}

} // namespace dewpoint::ui
