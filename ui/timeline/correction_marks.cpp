// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/correction_marks.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr double kMostHalf = 5.0; ///< of the diamond's height, pixels; less in low ribbons

} // namespace

void paintCorrections(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                      const TimelineRows& rows, const QPalette& palette) {
  painter.setPen(QPen(palette.color(QPalette::Text), 1.2));
  painter.setBrush(palette.color(QPalette::Base));
  for (const PositionCorrection& correction : model.corrections) {
    const double x = scale.xOf(static_cast<double>(correction.frame) + 0.5);
    if (x < rows.ribbonsArea.left() || x > rows.ribbonsArea.right() ||
        correction.target >= model.targetNames.size() || correction.trackedFrom) {
      continue;
    }
    const QRectF ribbon = rows.ribbonArea(correction.target);
    const double half = std::min(kMostHalf, 0.5 * ribbon.height());
    const QPointF middle(x, ribbon.center().y());
    painter.drawPolygon(QPolygonF({middle - QPointF(0.0, half), middle + QPointF(half, 0.0),
                                   middle + QPointF(0.0, half), middle - QPointF(half, 0.0)}));
  }
  painter.setBrush(Qt::NoBrush);
}

} // namespace dewpoint::ui
