// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/message_bar.h"

#include "ui/settings/symbolic_icon.h"
#include "ui/settings/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
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
  close_->setToolTip(tr("Close this message"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 4, 8, 4);
  layout->setSpacing(8);
  layout->addWidget(mark_);
  layout->addWidget(text_, 1);
  layout->addWidget(close_);
  connect(close_, &QToolButton::clicked, this, [this] {
    text_->clear();
    Q_EMIT wanted(false);
  });
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

void MessageBar::say(const QString& text, bool isError) {
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
