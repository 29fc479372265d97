// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_motion_mark.h"

#include "ui/style/theme.h"

#include <QPainter>
#include <QRectF>

namespace dewpoint::ui {

void paintBumpMark(QPainter& painter, const QRectF& image, const QString& text,
                   const QPalette& palette) {
  if (text.isEmpty()) {
    return;
  }
  painter.save();
  const QColor color = holdColor(HoldState::Lost, palette);
  const QRectF frame = image.adjusted(2.0, 2.0, -2.0, -2.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 4.0));
  painter.drawRect(frame);
  painter.setPen(QPen(color, 2.0, Qt::DashLine));
  painter.drawRect(frame);
  const QString mark = QStringLiteral("▲ ") + text;
  const QFontMetricsF metrics(painter.font());
  const QRectF label(frame.topLeft() + QPointF(6.0, 6.0),
                     QSizeF(metrics.horizontalAdvance(mark) + 12.0, metrics.height() + 6.0));
  QColor ground = palette.color(QPalette::Base);
  ground.setAlphaF(0.9F);
  painter.fillRect(label, ground);
  painter.setPen(color);
  painter.drawText(label, Qt::AlignCenter, mark);
  painter.restore();
}

} // namespace dewpoint::ui
