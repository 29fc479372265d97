// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/overlay_painter.h"

#include "core/session/view/camera_overlay.h"
#include "ui/cameraview/particle_painter.h"
#include "ui/style/halo.h"

#include <QPainter>
#include <QPolygonF>

#include <numbers>
#include <utility>

namespace dewpoint::ui {

namespace {

QPointF placed(double column, double row, const ImagePlacement& placement) {
  return placement.positionOf({column, row});
}

/// Dashed where the target is only thought to be.
void paintBox(QPainter& painter, const ImageBox& box, bool hidden, const ImagePlacement& placement,
              const QColor& color) {
  const QRectF place(placement.topLeft + QPointF(box.x, box.y) * placement.scale,
                     QSizeF(box.width, box.height) * placement.scale);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 4.4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(place);
  painter.setPen(
      QPen(color, 2.2, hidden ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  painter.drawRect(place);
}

} // namespace

void paintEllipse(QPainter& painter, const ImageEllipse& ellipse, const ImagePlacement& placement) {
  painter.save();
  painter.translate(placed(ellipse.center.x(), ellipse.center.y(), placement));
  painter.rotate(ellipse.angleRadians * 180.0 / std::numbers::pi);
  painter.drawEllipse(QPointF(0, 0), ellipse.semiMajorAxis * placement.scale,
                      ellipse.semiMinorAxis * placement.scale);
  painter.restore();
}

void paintOverlay(QPainter& painter, const CameraOverlay& overlay, const ImagePlacement& placement,
                  const QColor& color, const ParticleRamp& ramp) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(overlay.box ? 0.5 : 1.0); // what is in the box is to be seen
  paintParticles(painter, overlay, placement, ramp);
  painter.setOpacity(1.0);
  if (overlay.box) {
    paintBox(painter, *overlay.box, overlay.isBoxHidden, placement, color);
  }
  if (overlay.outline) {
    // Dashed: the target itself, not what is known of its position.
    painter.setBrush(Qt::NoBrush);
    for (const auto& [ink, width] : {std::pair{QColor(0, 0, 0, 150), 3.4}, std::pair{color, 1.6}}) {
      painter.setPen(QPen(ink, width, Qt::DashLine, Qt::FlatCap));
      paintEllipse(painter, *overlay.outline, placement);
    }
  }
  if (overlay.ellipse) {
    drawWithHalo(painter, color, 1.5, [&] { paintEllipse(painter, *overlay.ellipse, placement); });
  }
  if (overlay.truth) {
    const QPointF at = placed(overlay.truth->x(), overlay.truth->y(), placement);
    // A diamond: another shape than the cross of the estimate, which should lie inside it.
    drawWithHalo(painter, Qt::white, 1.3, [&] {
      painter.drawPolygon(QPolygonF(
          {at + QPointF(0, -7), at + QPointF(7, 0), at + QPointF(0, 7), at + QPointF(-7, 0)}));
    });
  }
  if (overlay.bestParticle) {
    const QPointF at = placed(overlay.bestParticle->x(), overlay.bestParticle->y(), placement);
    // A triangle: another shape than the cross of the mean and the diamond of the truth.
    drawWithHalo(painter, color, 1.5, [&] {
      painter.drawPolygon(
          QPolygonF({at + QPointF(0, -8), at + QPointF(7, 4.5), at + QPointF(-7, 4.5)}));
    });
  }
  if (overlay.estimate) {
    const QPointF at = placed(overlay.estimate->x(), overlay.estimate->y(), placement);
    drawWithHalo(painter, color, 1.8, [&] {
      for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + arm * 3.0, at + arm * 11.0);
      }
    });
  }
  painter.restore();
}

} // namespace dewpoint::ui
