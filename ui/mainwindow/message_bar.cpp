// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/message_bar.h"

#include "ui/settings/retranslation.h"
#include "ui/settings/symbolic_icon.h"
#include "ui/settings/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace dewpoint {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), mark_(new QLabel(this)), text_(new QLabel(this)),
      close_(new QToolButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  mark_->setObjectName(QStringLiteral("messageMark"));
  text_->setObjectName(QStringLiteral("messageText"));
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setObjectName(QStringLiteral("messageClose"));
  close_->setAutoRaise(true);
  inEveryLanguage(this, [this] { close_->setToolTip(tr("Close this message")); });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 4, 8, 4);
  layout->setSpacing(8);
  layout->addWidget(mark_);
  layout->addWidget(text_, 1);
  layout->addWidget(close_);
  connect(close_, &QToolButton::clicked, this, &MessageBar::close);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Button);
  applyPalette();
}

void MessageBar::showError(const QString& text) {
  say(text, true);
}
void MessageBar::showNotice(const QString& text) {
  say(text, false);
}
QString MessageBar::text() const {
  return text_->text();
}

void MessageBar::close() {
  text_->clear();
  clearAnswers();
  Q_EMIT wanted(false);
}

void MessageBar::clearAnswers() {
  for (QPushButton* answer : answers_) {
    answer->hide();
    answer->deleteLater(); // it may be the one that was clicked
  }
  answers_.clear();
}

void MessageBar::ask(const QString& question, const std::vector<Answer>& answers) {
  say(question, false);
  auto* row = static_cast<QHBoxLayout*>(layout());
  for (const Answer& answer : answers) {
    auto* button = new QPushButton(answer.first, this);
    button->setObjectName(QStringLiteral("messageAnswer%1").arg(answers_.size()));
    row->insertWidget(row->count() - 1, button);
    connect(button, &QPushButton::clicked, this, [this, act = answer.second] {
      close();
      act();
    });
    answers_.push_back(button);
  }
}

void MessageBar::say(const QString& text, bool isError) {
  clearAnswers();
  isError_ = isError;
  mark_->setText(isError ? QStringLiteral("▲") : QStringLiteral("●"));
  text_->setText(text);
  applyPalette();
  Q_EMIT wanted(true);
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void MessageBar::applyPalette() {
  close_->setIcon(symbolicIcon(QStringLiteral("close"), palette()));
  QPalette colors = mark_->palette();
  const QColor color =
      isError_ ? holdColor(HoldState::Lost, palette()) : palette().color(QPalette::Link);
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    mark_->setPalette(colors);
  }
}

} // namespace dewpoint
