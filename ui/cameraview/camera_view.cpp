// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_view.h"

#include "core/session/camera_overlay.h"
#include "core/session/run/snapshot.h"
#include "ui/cameraview/camera_motion_marker.h"
#include "ui/cameraview/evidence_painter.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/people_painter.h"
#include "ui/cameraview/volume_painter.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/reason_text.h"

#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
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

} // namespace

CameraView::CameraView(int camera, QWidget* parent) : QWidget(parent), camera_(camera) {
  setObjectName(QStringLiteral("cameraView%1").arg(camera));
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void CameraView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  if (const HoldState now = stateNow(); now != state_) {
    state_ = now;
    Q_EMIT stateChanged(state_);
  }
  refresh();
}

void CameraView::setMaskShown(bool shown) {
  maskShown_ = shown;
  refresh();
}

void CameraView::setEvidenceShown(bool shown) {
  evidenceShown_ = shown;
  refresh();
}

void CameraView::setBestShown(bool shown) {
  bestShown_ = shown;
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

HoldState CameraView::stateNow() const {
  if (!snapshot_ || !snapshot_->frames) {
    return HoldState::NoImages;
  }
  if (!frameOf(snapshot_, camera_)) {
    return HoldState::Missing;
  }
  return holdState(*snapshot_, camera_);
}

PictureSource CameraView::source() const {
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    return {};
  }
  return {.camera = camera_,
          .frame = frame,
          .mask = maskShown_ ? maskOf(snapshot_, camera_) : cv::Mat(),
          .isOfMotion = snapshot_->masksShowMotion,
          .size = fittedSize({frame->image.cols, frame->image.rows}),
          .maps = evidenceShown_ ? snapshot_ : nullptr};
}

QSize CameraView::fittedSize(const QSize& image) const {
  const QSizeF room = QSizeF(image).scaled(QSizeF(size()), Qt::KeepAspectRatio);
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(room.width() * ratio))),
          std::max(1, static_cast<int>(std::lround(room.height() * ratio)))};
}

bool CameraView::isSeen() const {
  return isVisible() && !window()->isMinimized();
}

bool CameraView::isDrawn() const {
  return !isSeen() || (picture_.source == source() && shown_ == snapshot_);
}

void CameraView::refresh() {
  if (!isSeen()) {
    rest(); // paintEvent() catches up
  } else if (follow()) {
    update();
  }
}

void CameraView::rest() {
  job_.cancel();
  ordered_ = {};
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
  rest();
}

bool CameraView::follow() {
  const PictureSource wanted = source();
  if (!wanted.frame) {
    picture_ = {};
  }
  if (wanted == picture_.source) {
    job_.cancel();
    ordered_ = {};
    shown_ = snapshot_;
    return true;
  }
  if (!(wanted == ordered_)) {
    ordered_ = wanted;
    job_.start([this, wanted, snapshot = snapshot_](const BackgroundJob::Progress&) {
      const auto drawn = std::make_shared<CameraPicture>(drawPicture(wanted));
      return [this, drawn, snapshot] {
        picture_ = std::move(*drawn);
        shown_ = snapshot;
        update();
      };
    });
  }
  return false;
}

void CameraView::paintEvent(QPaintEvent*) {
  follow(); // the size may be another one
  QPainter painter(this);
  const QColor ground = palette().color(QPalette::Base).lightness() < 128
                            ? palette().color(QPalette::Base)
                            : palette().color(QPalette::Window).darker(108);
  painter.fillRect(rect(), ground);
  const FramePtr frame = frameOf(snapshot_, camera_);
  if (!frame || frame->image.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     snapshot_ && snapshot_->frames
                         ? tr("This camera delivered no image for this frame.")
                         : tr("No images yet. Press play (Space), or open a project (Ctrl+O)."));
    return;
  }
  const QSize image(frame->image.cols, frame->image.rows);
  const double ratio = devicePixelRatioF();
  const QSizeF shown = QSizeF(fittedSize(image)) / ratio;
  const QPointF corner(std::round((width() - shown.width()) / 2.0 * ratio) / ratio,
                       std::round((height() - shown.height()) / 2.0 * ratio) / ratio);
  placement_ = {corner, shown.width() / image.width()};
  imageSize_ = image;
  if (!picture_.source.frame) {
    return; // the first one comes soon
  }
  const QRectF picture(corner, shown);
  painter.drawImage(picture, picture_.image);
  painter.setClipRect(picture);
  paintBelief(painter, picture);
}

void CameraView::paintBelief(QPainter& painter, const QRectF& picture) const {
  if (picture_.source.maps == shown_ && !picture_.motionMap.isNull()) {
    paintEvidence(painter, {{0, 0}, picture_.motionMap.size()}, picture_.motionMap, {}, placement_);
  }
  if (volume_ && shown_->rig && static_cast<std::size_t>(camera_) < shown_->rig->size()) {
    paintVolume(painter, (*shown_->rig)[static_cast<std::size_t>(camera_)], *volume_, placement_);
  }
  paintPeople(painter, *shown_, camera_, placement_, picture, chosenTarget_);
  paintPeopleTrouble(painter, *shown_, camera_, picture);
  for (std::size_t i = 0; i < shown_->targets.size(); ++i) {
    if (isPaintedByPeople(shown_->targets[i])) {
      continue;
    }
    if (picture_.source.maps == shown_) {
      paintEvidence(painter, mapPlace(shown_->targets[i], camera_), picture_.maps[i],
                    proposedOutlines(*shown_, camera_, shown_->targets[i]), placement_);
    }
    CameraOverlay overlay = cameraOverlay(*shown_, camera_, shown_->targets[i]);
    if (!bestShown_) {
      overlay.best.reset();
    }
    paintOverlay(painter, overlay, placement_,
                 targetColor(shown_->targets[i].target.name, static_cast<int>(i)));
  }
  paintCameraMotionMarker(painter, picture, cameraMotionText(cameraMotionOf(*shown_, camera_)),
                          palette());
}

} // namespace dewpoint::ui
