// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that are taken hold of in the bird's-eye view.
#include "ui/view3d/birds_eye_view.h"

#include <QPainter>

#include <cmath>

namespace dewpoint::ui {
namespace {

constexpr double kReachPx = 12.0;
constexpr double kCenterPx = 6.0;
constexpr double kTargetPx = 5.0;

double distance(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

void BirdsEyeView::setCameraHandles(std::vector<CameraHandle> handles, int chosen) {
  handles_ = std::move(handles);
  chosenHandle_ = chosen;
  if (handles_.empty()) {
    heldHandle_.reset();
  }
  update();
}

QPointF BirdsEyeView::inWidget(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d place = scene_.placeInPicture(point) / devicePixelRatioF();
  return {width() / 2.0 + place.x(), height() / 2.0 - place.y()};
}

bool BirdsEyeView::takeHandle(QPointF position) {
  if (!hasPicture()) {
    return false;
  }
  double nearest = kReachPx;
  heldHandle_.reset();
  for (int k = 0; k < static_cast<int>(handles_.size()); ++k) {
    const CameraHandle& handle = handles_[static_cast<std::size_t>(k)];
    if (const double away = distance(inWidget(handle.center), position); away < nearest) {
      nearest = away;
      heldHandle_ = HeldHandle{k, false, handle.center, position};
    }
    const double toTarget = distance(inWidget(handle.target), position);
    if (k == chosenHandle_ && toTarget < nearest) {
      nearest = toTarget;
      heldHandle_ = HeldHandle{k, true, handle.target, position};
    }
  }
  if (heldHandle_) {
    scene_.keepCamera(); // the picture must not move under the hand
    Q_EMIT cameraChosen(heldHandle_->camera);
    update();
  }
  return heldHandle_.has_value();
}

void BirdsEyeView::dragHandle(QPointF position) {
  const QPointF way = (position - heldHandle_->from) * devicePixelRatioF();
  const Eigen::Vector2d place =
      scene_.placeInPicture(heldHandle_->start) + Eigen::Vector2d(way.x(), -way.y());
  const Eigen::Vector3d there = scene_.placeInWorld(place, heldHandle_->start);
  if (!there.allFinite()) {
    return;
  }
  heldHandle_->isTarget ? Q_EMIT cameraAimed(heldHandle_->camera, there)
                        : Q_EMIT cameraDragged(heldHandle_->camera, there);
}

void BirdsEyeView::paintHandles(QPainter& painter) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = palette().color(QPalette::Highlight);
  const QColor halo(0, 0, 0, 150);
  for (int k = 0; k < static_cast<int>(handles_.size()); ++k) {
    const CameraHandle& handle = handles_[static_cast<std::size_t>(k)];
    const QPointF center = inWidget(handle.center);
    painter.setBrush(Qt::NoBrush);
    if (k == chosenHandle_) {
      const QPointF target = inWidget(handle.target);
      painter.setPen(QPen(halo, 3.0));
      painter.drawLine(center, target);
      painter.drawEllipse(target, kTargetPx, kTargetPx);
      painter.setPen(QPen(color, 1.4, Qt::DashLine));
      painter.drawLine(center, target);
      painter.setPen(QPen(color, 1.6));
      painter.drawEllipse(target, kTargetPx, kTargetPx);
    }
    painter.setPen(QPen(halo, 3.0));
    painter.drawEllipse(center, kCenterPx, kCenterPx);
    painter.setPen(QPen(color, 1.6));
    painter.setBrush(k == chosenHandle_ ? QBrush(color) : QBrush(palette().color(QPalette::Base)));
    painter.drawEllipse(center, kCenterPx, kCenterPx);
  }
  painter.restore();
}

} // namespace dewpoint::ui
