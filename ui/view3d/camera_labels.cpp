// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/camera_labels.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kGapPx = 7.0; ///< from the pyramid, and from the handle at its apex
constexpr double kBorderPx = 2.0;
constexpr double kHaloPx = 3.0;

/// A pyramid in the picture.
struct Drawn {
  QString name;
  QPointF apex;
  QPointF away; ///< unit, from the image to the apex and beyond
  QPainterPath shape;
};

bool isShown(const CameraGlyph& glyph, const Scene3d& scene) {
  return scene.isInFront(glyph.center) &&
         std::ranges::all_of(glyph.corners,
                             [&](const auto& corner) { return scene.isInFront(corner); });
}

Drawn draw(const CameraGlyph& glyph, const ViewProjection& projection) {
  Drawn drawn{
      QString::fromStdString(glyph.name), projection.toWidget(glyph.center), {0.0, -1.0}, {}};
  drawn.shape.setFillRule(Qt::WindingFill);
  std::array<QPointF, 4> corners;
  std::ranges::transform(glyph.corners, corners.begin(),
                         [&](const auto& corner) { return projection.toWidget(corner); });
  QPointF middle;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const QPolygonF side{drawn.apex, corners[k], corners[(k + 1) % corners.size()], drawn.apex};
    drawn.shape.addPolygon(side);
    middle += 0.25 * corners[k];
  }
  drawn.shape.addPolygon({corners[0], corners[1], corners[2], corners[3], corners[0]});
  const QPointF away = drawn.apex - middle;
  const double length = std::hypot(away.x(), away.y());
  // Seen along its axis it has no back.
  if (length > kGapPx) {
    drawn.away = away / length;
  }
  return drawn;
}

/// The best place first.
std::array<QRectF, 5> placesFor(const Drawn& camera, const QSizeF& size) {
  const QRectF box = camera.shape.boundingRect();
  const auto about = [&](const QPointF& center) {
    return QRectF(center - QPointF(size.width() / 2.0, size.height() / 2.0), size);
  };
  const double across = size.width() / 2.0 + kGapPx;
  const double along = size.height() / 2.0 + kGapPx;
  // As far behind the apex as the text reaches in this direction.
  const double reach = std::abs(camera.away.x()) * size.width() / 2.0 +
                       std::abs(camera.away.y()) * size.height() / 2.0 + kGapPx;
  return {about(camera.apex + camera.away * reach), about({box.center().x(), box.top() - along}),
          about({box.center().x(), box.bottom() + along}),
          about({box.right() + across, box.center().y()}),
          about({box.left() - across, box.center().y()})};
}

} // namespace

std::vector<CameraLabels::Label> CameraLabels::labels(const QWidget& view,
                                                      const QRectF& taken) const {
  const ViewProjection projection(view, scene_);
  const QFontMetricsF metrics(view.font());
  const QRectF room = QRectF(view.rect()).adjusted(kBorderPx, kBorderPx, -kBorderPx, -kBorderPx);
  std::vector<Drawn> cameras;
  for (const CameraGlyph& glyph : scene_.cameraGlyphs()) {
    if (!glyph.name.empty() && isShown(glyph, scene_)) {
      Drawn drawn = draw(glyph, projection);
      if (drawn.shape.boundingRect().intersects(room)) {
        cameras.push_back(std::move(drawn));
      }
    }
  }
  std::vector<QRectF> texts;
  for (const Eigen::AlignedBox2d& text : scene_.textAreas()) {
    texts.push_back(
        QRectF(projection.toWidget(text.min()), projection.toWidget(text.max())).normalized());
  }
  std::vector<Label> placed;
  for (const Drawn& camera : cameras) {
    const QSizeF size(metrics.horizontalAdvance(camera.name), metrics.height());
    const auto isFree = [&](const QRectF& place) {
      return room.contains(place) && !taken.intersects(place) &&
             std::ranges::none_of(texts,
                                  [&](const QRectF& text) { return text.intersects(place); }) &&
             std::ranges::none_of(cameras,
                                  [&](const Drawn& one) { return one.shape.intersects(place); }) &&
             std::ranges::none_of(placed,
                                  [&](const Label& one) { return one.area.intersects(place); });
    };
    const auto places = placesFor(camera, size);
    const auto free = std::ranges::find_if(places, isFree);
    placed.push_back({camera.name, free != places.end() ? *free : places.front()});
  }
  return placed;
}

void CameraLabels::paint(QPainter& painter, const QWidget& view, const QRectF& taken) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QColor halo = view.palette().color(QPalette::Window);
  halo.setAlphaF(0.8F);
  const QFontMetricsF metrics(view.font());
  for (const Label& label : labels(view, taken)) {
    QPainterPath text;
    text.addText(label.area.left(), label.area.top() + metrics.ascent(), view.font(), label.text);
    painter.strokePath(text, QPen(halo, kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(text, view.palette().color(QPalette::WindowText));
  }
  painter.restore();
}

} // namespace dewpoint::ui
