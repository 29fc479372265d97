// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_row.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"

#include <QEvent>
#include <QLayout>

#include <algorithm>

namespace dewpoint::ui {

MessageRow::MessageRow(MessageBar* bar, QWidget* parent) : QToolBar(parent), bar_(bar) {
  setObjectName(QStringLiteral("messageRow"));
  onRetranslate(this, [this] { setWindowTitle(tr("Messages")); });
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  bar_->setParent(this);
  bar_->hide();
  bar_->installEventFilter(this);
  fit();
}

int MessageRow::neededHeight() const {
  if (bar_->isHidden()) {
    return 0;
  }
  bar_->layout()->activate();
  return std::max(bar_->layout()->minimumSize().height(),
                  bar_->layout()->hasHeightForWidth() ? bar_->layout()->heightForWidth(width())
                                                      : bar_->sizeHint().height());
}

QSize MessageRow::sizeHint() const {
  return {1, maximumHeight()};
}

QSize MessageRow::minimumSizeHint() const {
  return sizeHint();
}

void MessageRow::fit() {
  const int wanted = neededHeight();
  if (wanted != maximumHeight()) {
    Q_EMIT heightChanging();
    setFixedHeight(wanted);
    updateGeometry();
    Q_EMIT heightChanged();
  }
  bar_->setGeometry(0, 0, width(), wanted);
}

void MessageRow::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fit();
}

bool MessageRow::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
  case QEvent::ShowToParent:
  case QEvent::HideToParent:
  case QEvent::LayoutRequest:
  case QEvent::FontChange:
    fit();
    break;
  default:
    break;
  }
  return QToolBar::eventFilter(watched, event);
}

} // namespace dewpoint::ui
