// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/drop_zone.h"

#include "ui/start/start_colors.h"
#include "ui/style/spacing.h"
#include "ui/style/symbolic_icon.h"
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QPainter>

namespace dewpoint::ui {

namespace {

// Pixels; chosen.
constexpr int kDropSymbol = 40;
constexpr QSize kDropLeast(240, 128);

} // namespace

DropZone::DropZone(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("newDropZone"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
  setIcon(symbolicIcon(QStringLiteral("video"), palette()));
  onRetranslate(this, [this] { retranslateUi(); });
}

QSize DropZone::sizeHint() const {
  return kDropLeast;
}

void DropZone::retranslateUi() {
  setText(tr("Drop or click to add videos"));
  line_ = tr("One video or image folder per camera; you can also drop a calibration file");
  setAccessibleName(text());
  setAccessibleDescription(line_);
  update();
}

void DropZone::paintEvent(QPaintEvent* /*event*/) {
  constexpr double kCorner = 8.0;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = palette().color(QPalette::Highlight);
  const QColor ground = palette().color(QPalette::Base);
  const bool marked = hasFocus() || underMouse();
  painter.setBrush(mixedColor(ground, accent, isDown() ? 0.15 : underMouse() ? 0.06 : 0.0));
  painter.setPen(QPen(marked ? accent : palette().color(QPalette::Dark), hasFocus() ? 2.0 : 1.0,
                      Qt::DashLine));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kCorner, kCorner);
  QFont title = font();
  title.setWeight(QFont::DemiBold);
  title.setPointSizeF(title.pointSizeF() * 1.2);
  const int titleHeight = QFontMetrics(title).height();
  const int lineHeight = fontMetrics().height();
  int top = (height() - kDropSymbol - titleHeight - lineHeight - 2 * kSpacing) / 2;
  icon().paint(&painter, (width() - kDropSymbol) / 2, top, kDropSymbol, kDropSymbol);
  top += kDropSymbol + kSpacing;
  painter.setFont(title);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(0, top, width(), titleHeight), Qt::AlignCenter, text());
  top += titleHeight + kSpacing;
  painter.setFont(font());
  painter.setPen(secondaryTextColor(palette()));
  painter.drawText(QRect(0, top, width(), lineHeight), Qt::AlignCenter, line_);
}

void DropZone::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    setIcon(symbolicIcon(QStringLiteral("video"), palette()));
  }
}

} // namespace dewpoint::ui
