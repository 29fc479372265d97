// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/evidence_painter.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

/// From dark blue over purple and orange to light yellow: rising lightness, readable without
/// telling red from green.
QRgb heat(double share) {
  static constexpr std::array<std::array<double, 3>, 5> kStops{{{{13.0, 8.0, 80.0}},
                                                                {{110.0, 10.0, 140.0}},
                                                                {{200.0, 60.0, 110.0}},
                                                                {{245.0, 140.0, 50.0}},
                                                                {{250.0, 240.0, 130.0}}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(low);
  std::array<int, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] =
        static_cast<int>(std::lround((1.0 - part) * kStops[low][k] + part * kStops[low + 1][k]));
  }
  return qRgba(color[0], color[1], color[2], 255);
}

QImage picture(const LikelihoodMap& map) {
  QImage image(map.area.width, map.area.height, QImage::Format_ARGB32);
  const double range = std::max(1e-9, map.most - map.least);
  for (int row = 0; row < image.height(); ++row) {
    const auto* values = map.logLikelihood.ptr<float>(row);
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      line[column] = heat((static_cast<double>(values[column]) - map.least) / range);
    }
  }
  return image;
}

Qt::PenStyle styleOf(CandidatePosition::Kind kind) {
  return kind == CandidatePosition::Kind::Existing ? Qt::SolidLine
         : kind == CandidatePosition::Kind::New    ? Qt::DashLine
                                                   : Qt::DotLine;
}

} // namespace

void paintEvidence(QPainter& painter, const LikelihoodMap& map,
                   const std::vector<ProposedOutline>& proposed, const ImagePlacement& placement) {
  painter.save();
  if (!map.area.empty()) {
    const QRectF area(placement.corner + QPointF(map.area.x, map.area.y) * placement.scale,
                      QSizeF(map.area.width, map.area.height) * placement.scale);
    painter.setOpacity(0.72);
    painter.drawImage(area, picture(map));
    painter.setOpacity(1.0);
    painter.setPen(QColor(255, 255, 255, 160));
    painter.drawRect(area);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const ProposedOutline& outline : proposed) {
    const QPointF center =
        placement.corner +
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
