// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/path_field.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyleOptionFrame>
#include <QToolTip>

namespace dewpoint::ui {

QRect PathField::textRect() const {
  constexpr int kTextMargin = 2; // as QLineEdit has it
  QStyleOptionFrame option;
  initStyleOption(&option);
  return style()
      ->subElementRect(QStyle::SE_LineEditContents, &option, this)
      .adjusted(kTextMargin, 0, -kTextMargin, 0);
}

QString PathField::shownText() const {
  return fontMetrics().elidedText(text(), Qt::ElideLeft, textRect().width());
}

bool PathField::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && shownText() != text()) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       text() + QLatin1Char('\n') + toolTip(), this);
    return true;
  }
  return QLineEdit::event(event);
}

void PathField::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (hasFocus() || shown == text()) {
    QLineEdit::paintEvent(event);
    return;
  }
  QPainter painter(this);
  QStyleOptionFrame option;
  initStyleOption(&option);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(textRect(), Qt::AlignLeft | Qt::AlignVCenter, shown);
}

} // namespace dewpoint::ui
