// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/people_painter.h"

#include "core/base/overloaded.h"
#include "core/session/snapshot/snapshot_state.h"
#include "core/session/view/camera_overlay.h"
#include "ui/style/halo.h"
#include "ui/style/identity_badge.h"
#include "ui/style/theme.h"
#include "ui/text/people_text.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr double kFarOff = 1e4; ///< pixels outside an image, where nothing is drawn anyway

QPolygonF outlineOf(const Projector& projector, const ConvexHull& hull,
                    const ImagePlacement& placement) {
  QPolygonF outline;
  for (const Eigen::Vector2d& corner : projectedHull(projector, hull)) {
    const Eigen::Vector2d pixel = corner.cwiseMax(-kFarOff).cwiseMin(kFarOff);
    outline << placement.topLeft + QPointF(pixel.x() + 0.5, pixel.y() + 0.5) * placement.scale;
  }
  return outline;
}

void paintHull(QPainter& painter, const QPolygonF& outline, const QColor& color, bool held,
               bool chosen) {
  QColor veil = color;
  veil.setAlphaF(chosen ? 0.3F : 0.16F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawPolygon(outline);
  drawWithHalo(
      painter, color, chosen ? 3.0 : 2.0, [&] { painter.drawPolygon(outline); },
      held ? Qt::SolidLine : Qt::DashLine);
}

} // namespace

void paintPeople(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                 const ImagePlacement& placement, const QRectF& room, int chosen) {
  const auto index = static_cast<std::size_t>(camera);
  if (!snapshot.rig || camera < 0 || index >= snapshot.rig->size()) {
    return;
  }
  const Projector projector((*snapshot.rig)[index]);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const PersonInSnapshot& person : peopleIn(snapshot)) {
    const TargetSnapshot& target = *person.target;
    const int k = static_cast<int>(person.targetIndex);
    const bool isChosen = k == chosen;
    const QColor color = targetColor(target.target.name, k);
    if (!target.shape) {
      const CameraOverlay overlay = cameraOverlay(snapshot, camera, target);
      paintOverlay(painter, overlay, placement, color, ParticleRamp::tintedRamp(color));
      if (overlay.estimate) {
        const QPointF middle(overlay.estimate->x() + 0.5, overlay.estimate->y() + 0.5);
        paintIdentityBadge(painter, person.estimate->identity,
                           placement.topLeft + middle * placement.scale - QPointF(0.0, 14.0), room,
                           isChosen);
      }
      continue;
    }
    const QPolygonF outline = outlineOf(projector, target.shape->hull, placement);
    if (outline.size() < 3 || !outline.boundingRect().intersects(room)) {
      continue;
    }
    paintHull(painter, outline, color, target.status == TargetStatus::Held, isChosen);
    const auto top = std::ranges::min_element(outline, {}, &QPointF::y);
    paintIdentityBadge(painter, person.estimate->identity, *top - QPointF(0.0, 3.0), room,
                       isChosen);
  }
  painter.restore();
}

bool isPaintedAsPerson(const TargetSnapshot& target) {
  return std::visit(Overloaded{[](const SphereEstimate&) { return false; },
                               [](const BoxEstimate&) { return false; },
                               [](const PersonEstimate&) { return true; },
                               [](const AbsentEstimate&) { return false; }},
                    target.estimate);
}

void paintPeopleProblem(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                        const QRectF& room) {
  QString text = peopleObstacleText(snapshot, camera);
  if (text.isEmpty()) {
    return;
  }
  const auto share = learnedBackgroundShare(snapshot, camera);
  const QFontMetricsF metrics(painter.font());
  const double most = room.width() - 16.0;
  if (share && metrics.horizontalAdvance(text) + 24.0 > most) {
    text = shortBackgroundLearningText(*share);
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double width = std::min(most, metrics.horizontalAdvance(text) + 24.0);
  const double height = metrics.height() + 12.0;
  const QRectF pill(room.center().x() - width / 2.0, room.bottom() - height - 8.0, width, height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(pill, 6.0, 6.0);
  if (share) {
    const QRectF bar(pill.left() + 8.0, pill.bottom() - 5.0, pill.width() - 16.0, 2.5);
    painter.setBrush(QColor(255, 255, 255, 60));
    painter.drawRect(bar);
    painter.setBrush(QColor("#e6a100"));
    painter.drawRect(QRectF(bar.topLeft(), QSizeF(bar.width() * *share, bar.height())));
  }
  painter.setPen(Qt::white);
  painter.drawText(pill.adjusted(8.0, 0.0, -8.0, -3.0), Qt::AlignCenter,
                   metrics.elidedText(text, Qt::ElideRight, pill.width() - 16.0));
  painter.restore();
}

} // namespace dewpoint::ui
