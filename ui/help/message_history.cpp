// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/message_history.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {
constexpr QSize kHistorySize(680, 420);
} // namespace

MessageHistory::MessageHistory(const MessageBar& messages, QWidget* parent)
    : QDialog(parent), text_(new QPlainTextEdit(this)), copy_(new QPushButton(this)),
      close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("messageHistory"));
  text_->setObjectName(QStringLiteral("messageHistoryText"));
  text_->setReadOnly(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setPlainText(messages.recentMessages().join(QLatin1Char('\n')));
  text_->moveCursor(QTextCursor::End);
  copy_->setObjectName(QStringLiteral("messageHistoryCopy"));
  copy_->setEnabled(!messages.recentMessages().isEmpty());
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  close_->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(&messages, &MessageBar::messageShown, this, [this, shown = &messages] {
    text_->appendPlainText(shown->recentMessages().last()); // what is selected stays selected
    copy_->setEnabled(true);
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(text_, 1);
  column->addWidget(buttons);
  onRetranslate(this, [this] { retranslateUi(); });
  resize(kHistorySize);
}

QString MessageHistory::text() const {
  return text_->toPlainText();
}

void MessageHistory::retranslateUi() {
  setWindowTitle(tr("Messages – Dewpoint"));
  text_->setAccessibleName(tr("Messages, the newest last"));
  text_->setPlaceholderText(tr("There have been no messages yet."));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy all messages as text"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
}

} // namespace dewpoint::ui
