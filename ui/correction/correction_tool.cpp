// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/correction/correction_tool.h"

#include "core/session/session.h"
#include "core/session/snapshot/sight_lines.h"
#include "core/session/snapshot/snapshot_state.h"
#include "core/setup/clicks/clicked_correction.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/view3d/birds_eye_view.h"

#include <QPolygonF>

namespace dewpoint::ui {

namespace {

constexpr double kGrabReachPx = 24.0; ///< of the widget: an estimate this near is meant. Chosen

PointClick clickAt(int camera, const QPointF& pixel) {
  return {camera, {pixel.x(), pixel.y()}};
}

/// Nothing without a snapshot, too.
std::optional<QPointF> pixelIn(const TrackSnapshotPtr& snapshot, int camera,
                               const Eigen::Vector3d& position) {
  const auto pixel = snapshot ? pixelOf(*snapshot, camera, position) : std::nullopt;
  return pixel ? std::optional(QPointF(pixel->x(), pixel->y())) : std::nullopt;
}

bool hasCamera(const TrackSnapshotPtr& snapshot, int camera) {
  return snapshot && cameraOf(*snapshot, camera) != nullptr;
}

} // namespace

CorrectionTool::CorrectionTool(const Workbench& bench, BirdsEyeView& birdsEye, QObject* parent)
    : QObject(parent), bench_(bench), birdsEye_(birdsEye) {}

void CorrectionTool::attach(int camera, CameraView* view) {
  auto* overlay = new ImagePickOverlay(view);
  overlay->setObjectName(view->objectName() + QStringLiteral("Correction"));
  overlay->setPointDragging(true);
  overlay->hide();
  const Layer layer{camera, view, overlay};
  layers_.push_back(layer);
  const auto name = [this, overlay, camera] {
    overlay->setHint(tr("Drag the target to its true position"));
    overlay->setAccessibleName(
        tr("Image of %1: arrow keys move a cross, Enter sets the target's position there")
            .arg(bench_.cameras.nameOf(camera)));
  };
  onRetranslate(overlay, name);
  connect(&bench_.cameras, &CameraListModel::dataChanged, overlay, name);
  connect(overlay, &QObject::destroyed, this, [this, overlay] {
    std::erase_if(layers_, [overlay](const Layer& one) { return one.overlay == overlay; });
  });
  connect(overlay, &ImagePickOverlay::canceled, this, &CorrectionTool::canceled);
  connect(overlay, &ImagePickOverlay::viewChosen, this,
          [this, camera] { bench_.selection.selectCamera(camera); });
  connect(overlay, &ImagePickOverlay::pointGrabbed, this,
          [this, layer](const QPointF& pixel) { grab(layer, pixel); });
  connect(overlay, &ImagePickOverlay::pointMoved, this,
          [this, camera](const QPointF& pixel) { point(camera, pixel); });
  connect(overlay, &ImagePickOverlay::picked, this,
          [this, camera](const QRectF& region) { drop(camera, region.topLeft()); });
  connect(overlay, &ImagePickOverlay::dragEnded, this, [this] {
    drag_.reset();
    refresh();
  });
}

void CorrectionTool::setActive(bool active) {
  active_ = active;
  drag_.reset();
  for (const Layer& layer : layers_) {
    layer.overlay->setPicking(active);
    layer.overlay->setVisible(active);
    layer.overlay->raise();
  }
  if (active && bench_.session.isPlaying() && snapshot_ && !snapshot_->rerun) {
    bench_.session.session()->pause(); // nobody hits what moves on
  }
  refresh();
  if (active && !layers_.empty()) {
    layers_.front().overlay->setFocus(Qt::ShortcutFocusReason); // the keys move its cross
  }
}

void CorrectionTool::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  refresh();
}

int CorrectionTool::preferredTarget() const {
  const int count = static_cast<int>(bench_.document.project().targets.size());
  const int selected = bench_.selection.target();
  return selected >= 0 && selected < count ? selected : count == 1 ? 0 : -1;
}

CorrectionTool::Drag CorrectionTool::currentDrag() const {
  return drag_ ? *drag_ : Drag{preferredTarget(), snapshot_};
}

std::optional<Gaussian3> CorrectionTool::estimateOf(const Drag& drag) const {
  return drag.snapshot ? positionEstimate(*drag.snapshot, drag.target) : std::nullopt;
}

int CorrectionTool::targetAt(const Layer& layer, const QPointF& pixel) const {
  const int count = static_cast<int>(bench_.document.project().targets.size());
  const double reach = kGrabReachPx / layer.view->placement().scale;
  return snapshot_ ? targetIndexNear(*snapshot_, count, layer.camera, {pixel.x(), pixel.y()}, reach)
                   : -1;
}

void CorrectionTool::grab(const Layer& layer, const QPointF& pixel) {
  drag_ = Drag{-1, snapshot_};
  if (!snapshot_ || snapshot_->frame < 0) {
    return;
  }
  if (snapshot_->rerun) {
    Q_EMIT failed(
        tr("Frames are being tracked again: wait until tracking has finished, or pause it."));
    return;
  }
  const int pressed = targetAt(layer, pixel);
  drag_->target = pressed >= 0 ? pressed : preferredTarget();
  if (drag_->target < 0) {
    Q_EMIT failed(
        bench_.document.project().targets.empty()
            ? tr("There is no target yet: learn its color first.")
            : tr("Select a target in the panel Target first, or drag the estimate of a target."));
    return;
  }
  if (bench_.session.isPlaying()) {
    bench_.session.session()->pause();
  }
  bench_.selection.selectTarget(drag_->target);
}

Result<PositionCorrection> CorrectionTool::correctionOf(const Drag& drag, int camera,
                                                        const QPointF& pixel) const {
  return correctionFromClick(bench_.document.project(), *drag.snapshot->rig, drag.snapshot->frame,
                             drag.target, clickAt(camera, pixel), estimateOf(drag));
}

void CorrectionTool::point(int camera, const QPointF& pixel) {
  const Drag drag = currentDrag();
  if (!active_ || drag.target < 0 || !hasCamera(drag.snapshot, camera)) {
    return;
  }
  const PointClick click = clickAt(camera, pixel);
  const auto correction = correctionOf(drag, camera, pixel);
  const auto position =
      correction ? std::optional<Eigen::Vector3d>(correction->position) : std::nullopt;
  showGuides(correction ? correction->clicks : std::vector<PointClick>{click}, position);
  showLineOfSight(click, position);
}

bool CorrectionTool::canCorrect() const {
  return snapshot_ && snapshot_->frame >= 0 && !snapshot_->rerun && preferredTarget() >= 0;
}

void CorrectionTool::correctAt(int camera, const QPointF& pixel) {
  const Drag drag{preferredTarget(), snapshot_};
  if (!canCorrect() || !hasCamera(drag.snapshot, camera)) {
    return;
  }
  if (bench_.session.isPlaying()) {
    bench_.session.session()->pause();
  }
  bench_.selection.selectTarget(drag.target);
  reportCorrection(drag, camera, pixel);
}

void CorrectionTool::drop(int camera, const QPointF& pixel) {
  const Drag drag = currentDrag();
  if (!active_ || drag.target < 0 || !hasCamera(drag.snapshot, camera) ||
      drag.snapshot->frame < 0 || drag.snapshot->rerun) {
    return;
  }
  reportCorrection(drag, camera, pixel);
}

void CorrectionTool::reportCorrection(const Drag& drag, int camera, const QPointF& pixel) {
  const auto correction = correctionOf(drag, camera, pixel);
  if (correction) {
    Q_EMIT corrected(*correction);
  } else {
    Q_EMIT failed(errorText(correction.error()));
  }
}

void CorrectionTool::refresh() {
  if (drag_) {
    return; // the guides are those of what is dragged
  }
  clearGuides();
  if (!active_ || !snapshot_) {
    return;
  }
  const int target = preferredTarget();
  const auto estimate = estimateOf({target, snapshot_});
  for (const Layer& layer : layers_) {
    layer.overlay->setCrossStart(estimate ? pixelIn(snapshot_, layer.camera, estimate->mean)
                                          : std::nullopt);
  }
  const PositionCorrection* there =
      correctionAt(bench_.document.project(), snapshot_->frame, target);
  if (there != nullptr) {
    showGuides(there->clicks, there->position);
  }
}

void CorrectionTool::showGuides(const std::vector<PointClick>& clicks,
                                const std::optional<Eigen::Vector3d>& position) {
  for (const Layer& layer : layers_) {
    if (!hasCamera(snapshot_, layer.camera)) {
      continue;
    }
    std::vector<QPolygonF> lines;
    for (const PointClick& click : clicks) {
      for (const ImageLine& line : clickedRayLines(*snapshot_, click, layer.camera)) {
        QPolygonF& drawn = lines.emplace_back();
        for (const Eigen::Vector2d& pixel : line) {
          drawn << QPointF(pixel.x(), pixel.y());
        }
      }
    }
    layer.overlay->setGuides(std::move(lines),
                             position ? pixelIn(snapshot_, layer.camera, *position) : std::nullopt);
  }
}

void CorrectionTool::showLineOfSight(const PointClick& click,
                                     const std::optional<Eigen::Vector3d>& position) {
  birdsEye_.showLineOfSight(snapshot_ && position ? clickedRayEnds(*snapshot_, click, *position)
                                                  : std::vector<Eigen::Vector3d>());
}

void CorrectionTool::clearGuides() {
  for (const Layer& layer : layers_) {
    layer.overlay->setGuides({}, std::nullopt);
  }
  birdsEye_.showLineOfSight({});
}

} // namespace dewpoint::ui
