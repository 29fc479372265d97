// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_view.h"

#include "core/session/snapshot/snapshot.h"
#include "core/session/snapshot/snapshot_state.h"
#include "ui/cameraview/camera_motion_marker.h"
#include "ui/cameraview/image_navigation.h"
#include "ui/text/error_sentence.h"
#include "ui/text/reason_text.h"

#include <QContextMenuEvent>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

CameraView::CameraView(int camera, QWidget* parent) : QWidget(parent), camera_(camera) {
  setObjectName(QStringLiteral("cameraView%1").arg(camera));
  setAttribute(Qt::WA_OpaquePaintEvent);
  new ImageNavigation(this);
}

void CameraView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  if (const TrackingState now = currentState(); now != state_) {
    state_ = now;
    Q_EMIT stateChanged(state_);
  }
  refresh();
}

void CameraView::setMaskShown(bool shown) {
  look_.isMaskShown = shown;
  refresh();
}

void CameraView::setLikelihoodShown(bool shown) {
  look_.isLikelihoodShown = shown;
  refresh();
}

void CameraView::setBestParticleShown(bool shown) {
  look_.isBestParticleShown = shown;
  update();
}

void CameraView::setMagnifierShown(bool shown) {
  look_.isMagnifierShown = shown;
  update();
}

void CameraView::setVolume(const std::optional<WorldBox>& volume) {
  look_.volume = volume;
  update();
}

void CameraView::setChosenTarget(int target) {
  look_.chosenTarget = target;
  update();
}

TrackingState CameraView::currentState() const {
  if (!snapshot_ || !snapshot_->frames) {
    return TrackingState::NoImages;
  }
  if (!frameOf(snapshot_, camera_)) {
    return TrackingState::Missing;
  }
  return trackingState(*snapshot_, camera_);
}

CameraImageSource CameraView::source() const {
  CameraImageSource wanted = makeImageSource(snapshot_, camera_, look_, {});
  if (wanted.frame) {
    const ZoomSizes room = zoomSizesFor(*wanted.frame);
    wanted.imagePart = zoom_.visiblePart(room);
    wanted.size = zoom_.visiblePartSize(room);
    wanted.isZoomed = !zoom_.isFitted(room);
  }
  return wanted;
}

CameraViewOptions CameraView::options() const {
  CameraViewOptions look = look_;
  look.palette = palette();
  return look;
}

ZoomSizes CameraView::zoomSizesFor(const Frame& frame) const {
  return {{frame.image.cols, frame.image.rows}, size(), devicePixelRatioF()};
}

bool CameraView::updatePlacement() {
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    return false;
  }
  placement_ = zoom_.placement(zoomSizesFor(*frame));
  imageSize_ = {frame->image.cols, frame->image.rows};
  return true;
}

void CameraView::onZoomChanged() {
  updatePlacement(); // a click before the next picture is meant where it looks to be
  update();
}

bool CameraView::isZoomed() const {
  const FramePtr frame = frameOf(snapshot_, camera_);
  return frame && !frame->image.empty() && !zoom_.isFitted(zoomSizesFor(*frame));
}

void CameraView::zoomBy(double factor, const QPointF& position) {
  if (updatePlacement()) {
    zoom_.zoomBy(factor, position, {imageSize_, size(), devicePixelRatioF()});
    onZoomChanged();
  }
}

void CameraView::panBy(const QPointF& offset) {
  if (updatePlacement()) {
    zoom_.panBy(offset, {imageSize_, size(), devicePixelRatioF()});
    onZoomChanged();
  }
}

void CameraView::reveal(const QPointF& pixel) {
  if (updatePlacement()) {
    zoom_.reveal(pixel, {imageSize_, size(), devicePixelRatioF()});
    onZoomChanged();
  }
}

void CameraView::fitImage() {
  zoom_.fitToView();
  onZoomChanged();
}

std::optional<QPointF> CameraView::pixelAt(const QPointF& position) const {
  const QPointF pixel = placement_.pixelAt(position);
  const bool inside = pixel.x() >= -0.5 && pixel.y() >= -0.5 &&
                      pixel.x() < imageSize_.width() - 0.5 && pixel.y() < imageSize_.height() - 0.5;
  return inside ? std::optional(pixel) : std::nullopt;
}

void CameraView::contextMenuEvent(QContextMenuEvent* event) {
  const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
  const QRectF seen = imageSize_.isEmpty() ? QRectF(rect()) : shownArea();
  requestMenu(byKey ? seen.center() : QPointF(event->pos()));
}

bool CameraView::isVisibleOnScreen() const {
  return isVisible() && !window()->isMinimized();
}

bool CameraView::isDrawn() const {
  return !isVisibleOnScreen() || (picture_.source == source() && shown_ == snapshot_);
}

void CameraView::refresh() {
  if (!isVisibleOnScreen()) {
    stopDrawing(); // paintEvent() catches up
  } else if (showNewest()) {
    update();
  }
}

void CameraView::stopDrawing() {
  job_.cancel();
  requestedSource_ = {};
  // What is still of the newest frame is shown at once when the view is raised.
  const FramePtr newest = frameOf(snapshot_, camera_);
  if (newest == nullptr || picture_.source.frame != newest) {
    picture_ = {};
    shown_.reset();
  }
}

void CameraView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  update(); // a window that was minimized comes back with its old pixels
}

void CameraView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  stopDrawing();
}

bool CameraView::showNewest() {
  const CameraImageSource wanted = source();
  if (!wanted.frame) {
    picture_ = {};
  }
  if (wanted == picture_.source) {
    job_.cancel();
    requestedSource_ = {};
    shown_ = snapshot_;
    return true;
  }
  if (!(wanted == requestedSource_)) {
    requestedSource_ = wanted;
    job_.start([this, wanted, snapshot = snapshot_](const BackgroundJob::Progress&) {
      const auto drawn = std::make_shared<CameraImage>(drawCameraImage(wanted));
      return [this, drawn, snapshot] {
        picture_ = std::move(*drawn);
        shown_ = snapshot;
        update();
      };
    });
  }
  return false;
}

QString CameraView::problemText() const {
  // That of a recording is about all of its images, and does not cover one of them.
  const bool isLive = snapshot_ && !snapshot_->frameCount && !snapshot_->isPast;
  const Error* notice = isLive ? noticeOf(*snapshot_, camera_) : nullptr;
  return notice != nullptr ? errorText(*notice) : QString();
}

void CameraView::paintEvent(QPaintEvent*) {
  showNewest(); // the size may be another one
  QPainter painter(this);
  painter.fillRect(rect(), imageBackgroundColor(palette()));
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     missingImageText(snapshot_, camera_));
    return;
  }
  updatePlacement();
  if (!picture_.source.frame) {
    return; // the first one comes soon
  }
  painter.drawImage(drawnArea(), picture_.image);
  painter.setClipRect(shownArea().toAlignedRect()); // whole pixels are clipped faster
  paintEstimates(painter, picture_, shown_, options(),
                 {.placement = placement_, .visibleArea = shownArea(), .isZoomed = isZoomed()});
  paintCameraProblem(painter, shownArea(), problemText(), palette());
  reportPainted();
}

void CameraView::reportPainted() {
  const bool isLive = shown_ && !shown_->frameCount && !shown_->isPast && shown_->isTracked &&
                      shown_->state == PlayState::Playing;
  if (isLive && shown_->frame != reportedFrame_) {
    reportedFrame_ = shown_->frame;
    Q_EMIT estimatePainted(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - shown_->estimatedAt)
            .count());
  }
}

QRectF CameraView::drawnArea() const {
  const double ratio = devicePixelRatioF();
  const CameraImageSource& source = picture_.source;
  const QPointF corner =
      (placement_.topLeft + QPointF(source.imagePart.topLeft()) * placement_.scale) * ratio;
  // Without a fraction of a pixel, so that it is drawn one to one.
  const QSizeF wanted = QSizeF(source.imagePart.size()) * (placement_.scale * ratio);
  const bool isThatSize = std::abs(wanted.width() - source.size.width()) < 1.0 &&
                          std::abs(wanted.height() - source.size.height()) < 1.0;
  return {QPointF(std::round(corner.x()), std::round(corner.y())) / ratio,
          (isThatSize ? QSizeF(source.size) : wanted) / ratio};
}

} // namespace dewpoint::ui
