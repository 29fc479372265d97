// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/zoom_label.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QPainter>
#include <QRectF>

namespace dewpoint::ui {

QRectF paintZoomLabel(QPainter& painter, const QRectF& area, double scale) {
  const QString text =
      QCoreApplication::translate("CameraView", "%1×").arg(significantDigitsText(scale, 2));
  const QFontMetricsF metrics(painter.font());
  const QSizeF pill(metrics.horizontalAdvance(text) + 14.0, metrics.height() + 4.0);
  const QRectF place(area.bottomRight() - QPointF(pill.width() + 8.0, pill.height() + 8.0), pill);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 130));
  painter.drawRoundedRect(place, pill.height() / 2.0, pill.height() / 2.0);
  painter.setPen(QColor(255, 255, 255, 220));
  painter.drawText(place, Qt::AlignCenter, text);
  painter.restore();
  return place;
}

} // namespace dewpoint::ui
