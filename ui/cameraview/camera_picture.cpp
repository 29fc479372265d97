// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_picture.h"

#include "core/session/snapshot/snapshot.h"
#include "core/session/view/camera_overlay.h"
#include "ui/cameraview/camera_motion_marker.h"
#include "ui/cameraview/cloud_inset.h"
#include "ui/cameraview/evidence_painter.h"
#include "ui/cameraview/image_zoom.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/particle_ramp.h"
#include "ui/cameraview/people_painter.h"
#include "ui/cameraview/volume_painter.h"
#include "ui/cameraview/zoom_label.h"
#include "ui/style/target_colors.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/reason_text.h"

#include <QCoreApplication>
#include <QPainter>

#include <cstddef>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr int kMissingTextMargin = 16; ///< around the text instead of an image

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

/// The colors in which the targets are drawn over an image.
std::vector<QColor> overlayColors(const TrackSnapshot& snapshot) {
  return targetColors(displayColorSources(snapshot), DisplayBackground::Image);
}

/// Several targets are told apart by their colors, of a single one the weights are.
ParticleRamp rampOf(const TrackSnapshot& snapshot, const QColor& color) {
  return snapshot.targets.size() > 1 ? ParticleRamp::tintedRamp(color) : ParticleRamp::heatRamp();
}

CameraOverlay shownOverlay(const TrackSnapshot& snapshot, int camera, std::size_t target,
                           const CameraViewOptions& look) {
  CameraOverlay overlay = cameraOverlay(snapshot, camera, snapshot.targets[target]);
  if (!look.isBestParticleShown) {
    overlay.bestParticle.reset();
  }
  return overlay;
}

void paintInset(QPainter& painter, const CameraImageSource& source, const TrackSnapshot& snapshot,
                const std::vector<QColor>& colors, const CameraViewOptions& look,
                const CameraImageArea& place, const std::vector<QRectF>& taken) {
  const auto& targets = snapshot.targets;
  const std::size_t chosen =
      look.chosenTarget >= 0 && static_cast<std::size_t>(look.chosenTarget) < targets.size()
          ? static_cast<std::size_t>(look.chosenTarget)
          : 0;
  const cv::Mat& image = source.frame->image;
  if (!look.isMagnifierShown || targets.empty() || isPaintedAsPerson(targets[chosen]) ||
      !targets[chosen].target.isShown || targets[chosen].status != TargetStatus::Held ||
      image.type() != CV_8UC3) {
    return;
  }
  const QColor& color = colors[chosen];
  paintCloudInset(painter, {.overlay = shownOverlay(snapshot, source.camera, chosen, look),
                            .image = image,
                            .placement = place.placement,
                            .area = place.visibleArea,
                            .color = color,
                            .ramp = rampOf(snapshot, color),
                            .occupiedAreas = taken});
}

} // namespace

FramePtr frameOf(const TrackSnapshotPtr& snapshot, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  if (!snapshot || !snapshot->frames || index >= snapshot->frames->frames.size()) {
    return nullptr;
  }
  return snapshot->frames->frames[index];
}

CameraImageSource makeImageSource(const TrackSnapshotPtr& snapshot, int camera,
                                  const CameraViewOptions& look, const QSize& size) {
  const FramePtr frame = frameOf(snapshot, camera);
  if (!frame || frame->image.empty()) {
    return {};
  }
  const cv::Mat mask = look.isMaskShown ? maskOf(snapshot, camera) : cv::Mat();
  return {.camera = camera,
          .frame = frame,
          .mask = mask,
          .isMotionMask = snapshot->masksShowMotion,
          .maskColors = mask.empty() ? std::vector<QColor>() : overlayColors(*snapshot),
          .imagePart = QRect(0, 0, frame->image.cols, frame->image.rows),
          .size = size,
          .isZoomed = false,
          .mapSnapshot = look.isLikelihoodShown ? snapshot : nullptr};
}

void paintEstimates(QPainter& painter, const CameraImage& image, const TrackSnapshotPtr& snapshot,
                    const CameraViewOptions& look, const CameraImageArea& place) {
  const int camera = image.source.camera;
  const bool hasMaps = image.source.mapSnapshot == snapshot;
  if (hasMaps && !image.motionMap.isNull()) {
    paintLikelihoodMap(painter, {{0, 0}, image.motionMap.size()}, image.motionMap, {},
                       place.placement);
  }
  if (look.volume && snapshot->rig && static_cast<std::size_t>(camera) < snapshot->rig->size()) {
    paintVolume(painter, (*snapshot->rig)[static_cast<std::size_t>(camera)], *look.volume,
                place.placement);
  }
  paintPeople(painter, *snapshot, camera, place.placement, place.visibleArea, look.chosenTarget);
  paintPeopleProblem(painter, *snapshot, camera, place.visibleArea);
  const std::vector<QColor> colors = overlayColors(*snapshot);
  for (std::size_t i = 0; i < snapshot->targets.size(); ++i) {
    const TargetSnapshot& target = snapshot->targets[i];
    if (isPaintedAsPerson(target) || !target.target.isShown) {
      continue;
    }
    if (hasMaps) {
      paintLikelihoodMap(painter, mapPlace(target, camera), image.likelihoodMaps[i],
                         proposedOutlines(*snapshot, camera, target), place.placement);
    }
    const QColor& color = colors[i];
    paintOverlay(painter, shownOverlay(*snapshot, camera, i, look), place.placement, color,
                 rampOf(*snapshot, color));
  }
  std::vector<QRectF> taken;
  if (place.isZoomed) {
    taken.push_back(paintZoomLabel(painter, place.visibleArea, place.placement.scale));
  }
  paintInset(painter, image.source, *snapshot, colors, look, place, taken);
  paintCameraMotionMarker(painter, place.visibleArea,
                          cameraMotionText(cameraMotionOf(*snapshot, camera)), look.palette);
}

QString missingImageText(const TrackSnapshotPtr& snapshot, int camera) {
  if (const Error* notice = snapshot ? noticeOf(*snapshot, camera) : nullptr) {
    return errorText(*notice);
  }
  return snapshot && snapshot->frames
             ? QCoreApplication::translate("CameraView",
                                           "This camera delivered no image for this frame.")
             : QCoreApplication::translate(
                   "CameraView", "No images yet. Press play (Space), or open a project (Ctrl+O).");
}

QColor imageBackgroundColor(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < 128
             ? palette.color(QPalette::Base)
             : palette.color(QPalette::Window).darker(108);
}

QImage cameraPicture(const TrackSnapshotPtr& snapshot, int camera, const CameraViewOptions& look,
                     const QSize& size) {
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(imageBackgroundColor(look.palette));
  QPainter painter(&picture);
  const FramePtr frame = frameOf(snapshot, camera);
  if (!frame || frame->image.empty()) {
    painter.setPen(look.palette.color(QPalette::PlaceholderText));
    painter.drawText(picture.rect().adjusted(kMissingTextMargin, kMissingTextMargin,
                                             -kMissingTextMargin, -kMissingTextMargin),
                     Qt::AlignCenter | Qt::TextWordWrap, missingImageText(snapshot, camera));
    return picture;
  }
  const QSize pixels(frame->image.cols, frame->image.rows);
  const ZoomSizes sizes{pixels, size, 1.0};
  const ImageZoom fitted;
  const CameraImage image =
      drawCameraImage(makeImageSource(snapshot, camera, look, fitted.visiblePartSize(sizes)));
  CameraImageArea place;
  place.placement = fitted.placement(sizes);
  place.visibleArea = place.placement.areaOf(pixels) & QRectF(picture.rect());
  painter.drawImage(place.placement.topLeft, image.image);
  painter.setClipRect(place.visibleArea);
  paintEstimates(painter, image, snapshot, look, place);
  return picture;
}

} // namespace dewpoint::ui
