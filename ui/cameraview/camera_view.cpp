// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_view.h"

#include "core/session/camera_overlay.h"
#include "core/session/run/snapshot.h"
#include "ui/cameraview/camera_motion_mark.h"
#include "ui/cameraview/evidence_painter.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/people_painter.h"
#include "ui/style/image.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/reason_text.h"

#include <QPaintEvent>
#include <QPainter>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

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

const cv::Scalar kMoving(228, 221, 213); ///< light gray; blue, green, red

/// The color in which each target is drawn, where a mask has its number.
cv::Mat colorsOfTargets(const cv::Mat& mask) {
  static const cv::Mat kTints = [] {
    cv::Mat tints(1, 256, CV_8UC3);
    for (int value = 0; value < 256; ++value) {
      const QColor tint = targetColor(255 - value);
      tints.at<cv::Vec3b>(value) =
          cv::Vec3b(static_cast<uchar>(tint.blue()), static_cast<uchar>(tint.green()),
                    static_cast<uchar>(tint.red()));
    }
    return tints;
  }();
  cv::Mat color;
  cv::cvtColor(mask, color, cv::COLOR_GRAY2BGR);
  cv::LUT(color, kTints, color);
  return color;
}

/// Everything that has no target's color steps back, and what has one is tinted.
cv::Mat tinted(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& color) {
  cv::Mat result = image * 0.35;
  cv::Mat bright;
  cv::addWeighted(image, 0.35, color, 0.65, 0.0, bright);
  bright.copyTo(result, mask);
  return result;
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
  update();
}

void CameraView::setMaskShown(bool shown) {
  maskShown_ = shown;
  update();
}

void CameraView::setEvidenceShown(bool shown) {
  evidenceShown_ = shown;
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

const QImage& CameraView::scaledImage(const QSize& devicePixels) {
  const FramePtr frame = frameOf(snapshot_, camera_);
  const cv::Mat mask = maskShown_ ? maskOf(snapshot_, camera_) : cv::Mat();
  if (scaled_.size() == devicePixels && scaledFrom_ == frame && scaledMask_.data == mask.data) {
    return scaled_;
  }
  cv::Mat image = frame->image;
  if (mask.size() == image.size() && !mask.empty()) {
    // What moves belongs to nobody yet: it has a color that is no identity's.
    image = tinted(image, mask,
                   snapshot_->family.findsTargets() ? cv::Mat(image.size(), image.type(), kMoving)
                                                    : colorsOfTargets(mask));
  }
  const bool smaller = devicePixels.width() < image.cols;
  cv::Mat fitted;
  cv::resize(image, fitted, cv::Size(devicePixels.width(), devicePixels.height()), 0.0, 0.0,
             smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
  scaled_ = toImage(fitted);
  scaledFrom_ = frame;
  scaledMask_ = mask;
  return scaled_;
}

void CameraView::paintEvent(QPaintEvent*) {
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
  const QSizeF room = QSizeF(image).scaled(QSizeF(size()), Qt::KeepAspectRatio);
  const double ratio = devicePixelRatioF();
  // Whole device pixels, so that the scaled image is drawn one to one.
  const QSize device(std::max(1, static_cast<int>(std::lround(room.width() * ratio))),
                     std::max(1, static_cast<int>(std::lround(room.height() * ratio))));
  const QSizeF shown = QSizeF(device) / ratio;
  const QPointF corner(std::round((width() - shown.width()) / 2.0 * ratio) / ratio,
                       std::round((height() - shown.height()) / 2.0 * ratio) / ratio);
  painter.drawImage(QRectF(corner, shown), scaledImage(device));

  painter.setClipRect(QRectF(corner, shown));
  placement_ = {corner, shown.width() / image.width()};
  imageSize_ = image;
  const QRectF picture(corner, shown);
  if (snapshot_->family.findsTargets()) {
    paintPeople(painter, *snapshot_, camera_, placement_, picture, chosenTarget_);
    paintPeopleTrouble(painter, *snapshot_, camera_, picture);
  }
  for (std::size_t i = 0; !snapshot_->family.findsTargets() && i < snapshot_->targets.size(); ++i) {
    if (evidenceShown_) {
      const auto& maps = snapshot_->targets[i].maps;
      const auto own = static_cast<std::size_t>(camera_);
      paintEvidence(painter, own < maps.size() ? maps[own] : LikelihoodMap{},
                    proposedOutlines(*snapshot_, camera_, snapshot_->targets[i]), placement_);
    }
    paintOverlay(painter, cameraOverlay(*snapshot_, camera_, snapshot_->targets[i]), placement_,
                 targetColor(snapshot_->targets[i].target.name, static_cast<int>(i)));
  }
  paintBumpMark(painter, picture, bumpText(bumpOf(*snapshot_, camera_)), palette());
}

} // namespace dewpoint::ui
