// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/thread_count_dialog.h"

#include "ui/preferences/preferences.h"
#include "ui/text/retranslation.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace dewpoint::ui {

ThreadCountDialog::ThreadCountDialog(int most, QWidget* parent)
    : QDialog(parent), label_(new QLabel(this)), threads_(new QSpinBox(this)),
      note_(new QLabel(this)), accept_(new QPushButton(this)), cancel_(new QPushButton(this)) {
  setObjectName(QStringLiteral("threadCountDialog"));
  threads_->setObjectName(QStringLiteral("threadCount"));
  accept_->setObjectName(QStringLiteral("threadCountAccept"));
  cancel_->setObjectName(QStringLiteral("threadCountCancel"));
  threads_->setRange(0, most); // 0: as many as there are cores
  threads_->setValue(Preferences().filterThreadCount());
  label_->setBuddy(threads_);
  note_->setWordWrap(true);
  accept_->setDefault(true);
  cancel_->setAutoDefault(false);
  auto* form = new QFormLayout;
  form->addRow(label_, threads_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(accept_, QDialogButtonBox::AcceptRole);
  buttons->addButton(cancel_, QDialogButtonBox::RejectRole);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(note_);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    Preferences().setFilterThreadCount(threads_->value());
    accept();
  });
  onRetranslate(this, [this] { retranslateUi(); });
}

void ThreadCountDialog::retranslateUi() {
  setWindowTitle(tr("Filter threads"));
  label_->setText(tr("Threads"));
  threads_->setSpecialValueText(tr("automatic"));
  threads_->setToolTip(
      tr("Number of threads that compute the filter. The results do not depend on it"));
  note_->setText(tr("The new number is used from the next frame on."));
  accept_->setText(tr("OK"));
  accept_->setToolTip(tr("Use this number"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Close and keep the current number"));
}

} // namespace dewpoint::ui
