// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_view.h"

#include "core/session/camera_overlay.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/camera_motion_marker.h"
#include "ui/cameraview/cloud_inset.h"
#include "ui/cameraview/evidence_painter.h"
#include "ui/cameraview/image_navigation.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/particle_ramp.h"
#include "ui/cameraview/people_painter.h"
#include "ui/cameraview/volume_painter.h"
#include "ui/cameraview/zoom_label.h"
#include "ui/text/camera_motion_text.h"
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

namespace {

FramePtr frameOf(const TrackSnapshotPtr& snapshot, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  if (!snapshot || !snapshot->frames || index >= snapshot->frames->frames.size()) {
    return nullptr;
  }
  return snapshot->frames->frames[index];
}

cv::Mat maskOf(const TrackSnapshotPtr& snapshot, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  return snapshot && index < snapshot->masks.size() ? snapshot->masks[index] : cv::Mat();
}

/// Where the likelihood map of a target lies in the image of a camera, pixels.
QRect mapPlace(const TargetSnapshot& target, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  if (index >= target.maps.size()) {
    return {};
  }
  const cv::Rect& area = target.maps[index].area;
  return {area.x, area.y, area.width, area.height};
}

/// Several targets are told apart by their colors, of a single one the weights are.
ParticleRamp rampOf(const TrackSnapshot& snapshot, const QColor& color) {
  return snapshot.targets.size() > 1 ? ParticleRamp::tinted(color) : ParticleRamp::heat();
}

} // namespace

CameraView::CameraView(int camera, QWidget* parent) : QWidget(parent), camera_(camera) {
  setObjectName(QStringLiteral("cameraView%1").arg(camera));
  setAttribute(Qt::WA_OpaquePaintEvent);
  new ImageNavigation(this);
}

void CameraView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  if (const HoldState now = currentState(); now != state_) {
    state_ = now;
    Q_EMIT stateChanged(state_);
  }
  refresh();
}

void CameraView::setMaskShown(bool shown) {
  maskShown_ = shown;
  refresh();
}

void CameraView::setLikelihoodShown(bool shown) {
  likelihoodShown_ = shown;
  refresh();
}

void CameraView::setBestShown(bool shown) {
  bestShown_ = shown;
  update();
}

void CameraView::setMagnifierShown(bool shown) {
  magnifierShown_ = shown;
  update();
}

void CameraView::setVolume(const std::optional<WorldBox>& volume) {
  volume_ = volume;
  update();
}

void CameraView::setChosenTarget(int target) {
  chosenTarget_ = target;
  update();
}

HoldState CameraView::currentState() const {
  if (!snapshot_ || !snapshot_->frames) {
    return HoldState::NoImages;
  }
  if (!frameOf(snapshot_, camera_)) {
    return HoldState::Missing;
  }
  return holdState(*snapshot_, camera_);
}

CameraImageSource CameraView::source() const {
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    return {};
  }
  const ZoomSizes room = zoomSizesFor(*frame);
  return {.camera = camera_,
          .frame = frame,
          .mask = maskShown_ ? maskOf(snapshot_, camera_) : cv::Mat(),
          .isOfMotion = snapshot_->masksShowMotion,
          .part = zoom_.part(room),
          .size = zoom_.partSize(room),
          .isZoomed = !zoom_.isFitted(room),
          .maps = likelihoodShown_ ? snapshot_ : nullptr};
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

void CameraView::panBy(const QPointF& way) {
  if (updatePlacement()) {
    zoom_.panBy(way, {imageSize_, size(), devicePixelRatioF()});
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
  zoom_.fit();
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
  const bool isLive = snapshot_ && !snapshot_->frameCount && !snapshot_->past;
  const Error* notice = isLive ? noticeOf(*snapshot_, camera_) : nullptr;
  return notice != nullptr ? errorText(*notice) : QString();
}

QString CameraView::missingImageText() const {
  if (const Error* notice = snapshot_ ? noticeOf(*snapshot_, camera_) : nullptr) {
    return errorText(*notice);
  }
  return snapshot_ && snapshot_->frames
             ? tr("This camera delivered no image for this frame.")
             : tr("No images yet. Press play (Space), or open a project (Ctrl+O).");
}

void CameraView::paintEvent(QPaintEvent*) {
  showNewest(); // the size may be another one
  QPainter painter(this);
  const QColor ground = palette().color(QPalette::Base).lightness() < 128
                            ? palette().color(QPalette::Base)
                            : palette().color(QPalette::Window).darker(108);
  painter.fillRect(rect(), ground);
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     missingImageText());
    return;
  }
  updatePlacement();
  if (!picture_.source.frame) {
    return; // the first one comes soon
  }
  painter.drawImage(drawnArea(), picture_.image);
  painter.setClipRect(shownArea());
  paintEstimates(painter);
  reportPainted();
}

void CameraView::reportPainted() {
  const bool isLive = shown_ && !shown_->frameCount && !shown_->past && shown_->tracked &&
                      shown_->state == PlayState::Playing;
  if (isLive && shown_->frame != reportedFrame_) {
    reportedFrame_ = shown_->frame;
    Q_EMIT estimatePainted(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - shown_->estimated)
            .count());
  }
}

QRectF CameraView::drawnArea() const {
  const double ratio = devicePixelRatioF();
  const CameraImageSource& source = picture_.source;
  const QPointF corner =
      (placement_.corner + QPointF(source.part.topLeft()) * placement_.scale) * ratio;
  // Without a fraction of a pixel, so that it is drawn one to one.
  const QSizeF wanted = QSizeF(source.part.size()) * (placement_.scale * ratio);
  const bool isThatSize = std::abs(wanted.width() - source.size.width()) < 1.0 &&
                          std::abs(wanted.height() - source.size.height()) < 1.0;
  return {QPointF(std::round(corner.x()), std::round(corner.y())) / ratio,
          (isThatSize ? QSizeF(source.size) : wanted) / ratio};
}

CameraOverlay CameraView::overlayOf(std::size_t target) const {
  CameraOverlay overlay = cameraOverlay(*shown_, camera_, shown_->targets[target]);
  if (!bestShown_) {
    overlay.best.reset();
  }
  return overlay;
}

void CameraView::paintEstimates(QPainter& painter) const {
  const QRectF seen = shownArea();
  if (picture_.source.maps == shown_ && !picture_.motionMap.isNull()) {
    paintLikelihoodMap(painter, {{0, 0}, picture_.motionMap.size()}, picture_.motionMap, {},
                       placement_);
  }
  if (volume_ && shown_->rig && static_cast<std::size_t>(camera_) < shown_->rig->size()) {
    paintVolume(painter, (*shown_->rig)[static_cast<std::size_t>(camera_)], *volume_, placement_);
  }
  paintPeople(painter, *shown_, camera_, placement_, seen, chosenTarget_);
  paintPeopleObstacle(painter, *shown_, camera_, seen);
  for (std::size_t i = 0; i < shown_->targets.size(); ++i) {
    if (isPaintedAsPerson(shown_->targets[i])) {
      continue;
    }
    if (picture_.source.maps == shown_) {
      paintLikelihoodMap(painter, mapPlace(shown_->targets[i], camera_), picture_.maps[i],
                         proposedOutlines(*shown_, camera_, shown_->targets[i]), placement_);
    }
    const QColor color = targetColor(shown_->targets[i].target.name, static_cast<int>(i));
    paintOverlay(painter, overlayOf(i), placement_, color, rampOf(*shown_, color));
  }
  std::vector<QRectF> taken;
  if (isZoomed()) {
    taken.push_back(paintZoomLabel(painter, seen, placement_.scale));
  }
  paintInset(painter, taken);
  paintCameraMotionMarker(painter, seen, cameraMotionText(cameraMotionOf(*shown_, camera_)),
                          palette());
  paintCameraProblem(painter, seen, problemText(), palette());
}

void CameraView::paintInset(QPainter& painter, const std::vector<QRectF>& taken) const {
  const auto& targets = shown_->targets;
  const std::size_t chosen =
      chosenTarget_ >= 0 && static_cast<std::size_t>(chosenTarget_) < targets.size()
          ? static_cast<std::size_t>(chosenTarget_)
          : 0;
  const cv::Mat& image = picture_.source.frame->image;
  if (!magnifierShown_ || targets.empty() || isPaintedAsPerson(targets[chosen]) ||
      targets[chosen].status != TargetStatus::Held || image.type() != CV_8UC3) {
    return;
  }
  const QColor color = targetColor(targets[chosen].target.name, static_cast<int>(chosen));
  paintCloudInset(painter, {.overlay = overlayOf(chosen),
                            .image = image,
                            .placement = placement_,
                            .area = shownArea(),
                            .color = color,
                            .ramp = rampOf(*shown_, color),
                            .taken = taken});
}

} // namespace dewpoint::ui
