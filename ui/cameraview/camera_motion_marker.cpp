// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_motion_marker.h"

#include "ui/style/halo.h"
#include "ui/style/theme.h"

#include <QPainter>
#include <QRectF>

namespace dewpoint::ui {

void paintCameraProblem(QPainter& painter, const QRectF& image, const QString& text,
                        const QPalette& palette) {
  if (text.isEmpty()) {
    return;
  }
  constexpr double kMargin = 6.0;
  constexpr int kLayout = Qt::AlignCenter | Qt::TextWordWrap;
  painter.save();
  const QString shown = QStringLiteral("◆ ") + text;
  const QRectF room = image.adjusted(2.0 * kMargin, 0.0, -2.0 * kMargin, -kMargin);
  QRectF label = painter.boundingRect(room, kLayout, shown);
  label.moveBottom(room.bottom());
  label = label.adjusted(-kMargin, -kMargin, kMargin, 0.0).intersected(image);
  QColor ground = palette.color(QPalette::Base);
  ground.setAlphaF(0.9F);
  painter.fillRect(label, ground);
  painter.setPen(trackingStateColor(TrackingState::Ambiguous, palette));
  painter.drawText(label, kLayout, shown);
  painter.restore();
}

void paintCameraMotionMarker(QPainter& painter, const QRectF& image, const QString& text,
                             const QPalette& palette) {
  if (text.isEmpty()) {
    return;
  }
  painter.save();
  const QColor color = trackingStateColor(TrackingState::Lost, palette);
  const QRectF frame = image.adjusted(2.0, 2.0, -2.0, -2.0);
  drawWithHalo(
      painter, color, 2.0, [&] { painter.drawRect(frame); }, Qt::DashLine, edgeHalo(150, 2.0));
  const QString marker = QStringLiteral("▲ ") + text;
  const QFontMetricsF metrics(painter.font());
  const QRectF label(frame.topLeft() + QPointF(6.0, 6.0),
                     QSizeF(metrics.horizontalAdvance(marker) + 12.0, metrics.height() + 6.0));
  QColor ground = palette.color(QPalette::Base);
  ground.setAlphaF(0.9F);
  painter.fillRect(label, ground);
  painter.setPen(color);
  painter.drawText(label, Qt::AlignCenter, marker);
  painter.restore();
}

} // namespace dewpoint::ui
