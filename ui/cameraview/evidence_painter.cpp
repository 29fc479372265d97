// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/evidence_painter.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

Qt::PenStyle styleOf(CandidatePosition::Kind kind) {
  return kind == CandidatePosition::Kind::Existing ? Qt::SolidLine
         : kind == CandidatePosition::Kind::New    ? Qt::DashLine
                                                   : Qt::DotLine;
}

} // namespace

void paintLikelihoodMap(QPainter& painter, const QRect& place, const QImage& map,
                        const std::vector<ProposedOutline>& proposed,
                        const ImagePlacement& placement) {
  painter.save();
  if (!map.isNull()) {
    const QRectF area(placement.topLeft + QPointF(place.topLeft()) * placement.scale,
                      QSizeF(place.size()) * placement.scale);
    painter.setOpacity(0.72);
    painter.drawImage(area, map);
    painter.setOpacity(1.0);
    painter.setPen(QColor(255, 255, 255, 160));
    painter.drawRect(area);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const ProposedOutline& outline : proposed) {
    const QPointF center =
        placement.topLeft +
        QPointF(outline.center.x() + 0.5, outline.center.y() + 0.5) * placement.scale;
    const double radius = std::max(4.0, outline.radius * placement.scale);
    for (const auto& [color, width] :
         {std::pair(QColor(0, 0, 0, 170), 3.4), std::pair(QColor(Qt::white), 1.4)}) {
      painter.setPen(QPen(color, width, styleOf(outline.kind), Qt::FlatCap));
      painter.drawEllipse(center, radius, radius);
    }
  }
  painter.restore();
}

} // namespace dewpoint::ui
