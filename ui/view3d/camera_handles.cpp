// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/camera_handles.h"

#include "ui/style/halo.h"
#include "ui/view3d/view_projection.h"

#include <QPainter>
#include <QWidget>

#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kReachPx = 12.0;
constexpr double kCenterPx = 6.0;
constexpr double kTargetPx = 5.0;
constexpr double kLinePx = 1.4; ///< width of an outline

double distance(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

CameraHandles::CameraHandles(QWidget& view, Scene3d& scene)
    : QObject(&view), view_(view), scene_(scene) {}

void CameraHandles::setHandles(std::vector<CameraHandle> handles, int chosen) {
  handles_ = std::move(handles);
  chosen_ = chosen;
  if (handles_.empty()) {
    drag_.reset();
  }
  view_.update();
}

bool CameraHandles::grab(QPointF position) {
  const ViewProjection projection(view_, scene_);
  double nearest = kReachPx;
  drag_.reset();
  for (int k = 0; k < static_cast<int>(handles_.size()); ++k) {
    const CameraHandle& handle = handles_[static_cast<std::size_t>(k)];
    if (const double away = distance(projection.toWidget(handle.center), position);
        away < nearest) {
      nearest = away;
      drag_ = Drag{k, false, handle.center, position};
    }
    const double toTarget = distance(projection.toWidget(handle.target), position);
    if (k == chosen_ && toTarget < nearest) {
      nearest = toTarget;
      drag_ = Drag{k, true, handle.target, position};
    }
  }
  if (drag_) {
    scene_.keepCurrentView(); // the picture must not move under the hand
    Q_EMIT cameraChosen(drag_->camera);
    view_.update();
  }
  return drag_.has_value();
}

void CameraHandles::drag(QPointF position) {
  const QPointF way = (position - drag_->startPosition) * view_.devicePixelRatioF();
  const Eigen::Vector2d place =
      scene_.projectToImage(drag_->startPoint) + Eigen::Vector2d(way.x(), -way.y());
  const Eigen::Vector3d there = scene_.unproject(place, drag_->startPoint);
  if (!there.allFinite()) {
    return;
  }
  drag_->isAimHandle ? Q_EMIT cameraAimed(drag_->camera, there)
                     : Q_EMIT cameraDragged(drag_->camera, there);
}

void CameraHandles::endDrag() {
  drag_.reset();
  Q_EMIT cameraDropped();
  view_.update();
}

void CameraHandles::paint(QPainter& painter) const {
  const ViewProjection projection(view_, scene_);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = view_.palette().color(QPalette::Highlight);
  const QPen halo = haloPen(kLinePx, edgeHalo(150, 1.6));
  for (int k = 0; k < static_cast<int>(handles_.size()); ++k) {
    const CameraHandle& handle = handles_[static_cast<std::size_t>(k)];
    const QPointF center = projection.toWidget(handle.center);
    painter.setBrush(Qt::NoBrush);
    if (k == chosen_) {
      const QPointF target = projection.toWidget(handle.target);
      painter.setPen(halo);
      painter.drawLine(center, target);
      painter.drawEllipse(target, kTargetPx, kTargetPx);
      painter.setPen(QPen(color, kLinePx, Qt::DashLine));
      painter.drawLine(center, target);
      painter.setPen(QPen(color, 1.6));
      painter.drawEllipse(target, kTargetPx, kTargetPx);
    }
    painter.setPen(halo);
    painter.drawEllipse(center, kCenterPx, kCenterPx);
    painter.setPen(QPen(color, 1.6));
    painter.setBrush(k == chosen_ ? QBrush(color) : QBrush(view_.palette().color(QPalette::Base)));
    painter.drawEllipse(center, kCenterPx, kCenterPx);
  }
  painter.restore();
}

} // namespace dewpoint::ui
