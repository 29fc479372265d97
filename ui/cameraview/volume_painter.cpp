// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/volume_painter.h"

#include "core/geometry/projected_lines.h"
#include "ui/style/halo.h"

#include <QPainter>
#include <QPolygonF>

namespace dewpoint::ui {

namespace {

// Chosen: seen on any image, and not in its way.

constexpr double kEdgeOpacity = 0.7; ///< 0 to 1
constexpr double kEdgeWidth = 1.0;   ///< widget units

} // namespace

void paintVolume(QPainter& painter, const Camera& camera, const WorldBox& volume,
                 const ImagePlacement& placement) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(kEdgeOpacity);
  for (const ImageLine& line : projectEdges(Projector(camera), volume)) {
    QPolygonF edge;
    for (const Eigen::Vector2d& pixel : line) {
      edge << placement.topLeft + QPointF(pixel.x() + 0.5, pixel.y() + 0.5) * placement.scale;
    }
    drawWithHalo(
        painter, Qt::white, kEdgeWidth, [&] { painter.drawPolyline(edge); }, Qt::DashLine);
  }
  painter.restore();
}

} // namespace dewpoint::ui
