// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_row.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/notice_list.h"

#include <QEvent>
#include <QLayout>

#include <algorithm>

namespace dewpoint::ui {

MessageRow::MessageRow(MessageBar* bar, NoticeList* notices, QWidget* parent)
    : QToolBar(parent), bar_(bar), notices_(notices) {
  setObjectName(QStringLiteral("messageRow"));
  onRetranslate(this, [this] { setWindowTitle(tr("Messages")); });
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  for (QWidget* part : {bar_, notices_}) {
    part->setParent(this);
    part->hide();
    part->installEventFilter(this);
  }
  fit();
}

int MessageRow::neededHeight(const QWidget* part) const {
  if (part->isHidden()) {
    return 0;
  }
  QLayout* layout = part->layout();
  layout->activate();
  return std::max(layout->minimumSize().height(), layout->hasHeightForWidth()
                                                      ? layout->heightForWidth(width())
                                                      : part->sizeHint().height());
}

QSize MessageRow::sizeHint() const {
  return {1, maximumHeight()};
}

QSize MessageRow::minimumSizeHint() const {
  return sizeHint();
}

void MessageRow::fit() {
  const int ofBar = neededHeight(bar_);
  const int ofNotices = neededHeight(notices_);
  const int wanted = ofBar + ofNotices;
  if (wanted != maximumHeight()) {
    Q_EMIT heightChanging();
    setFixedHeight(wanted);
    updateGeometry();
    Q_EMIT heightChanged();
  }
  bar_->setGeometry(0, 0, width(), ofBar);
  notices_->setGeometry(0, ofBar, width(), ofNotices);
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
