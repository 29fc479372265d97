// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/correction/correction_tool.h"

#include "core/geometry/projected_lines.h"
#include "core/session/session.h"
#include "core/setup/clicked_correction.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/view3d/birds_eye_view.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

// Chosen.

constexpr double kGrabReachPx = 24.0; ///< of the widget: an estimate this near is meant
constexpr double kBeyond = 1.25;      ///< a line of sight ends so many times as far as the position

PointClick clickAt(int camera, const QPointF& pixel) {
  return {camera, {pixel.x(), pixel.y()}};
}

/// The camera of a rig; null when it has none with this number.
const Camera* cameraOf(const TrackSnapshotPtr& snapshot, int camera) {
  const bool isThere = snapshot && snapshot->rig && camera >= 0 &&
                       static_cast<std::size_t>(camera) < snapshot->rig->size();
  return isThere ? &(*snapshot->rig)[static_cast<std::size_t>(camera)] : nullptr;
}

std::optional<QPointF> pixelOf(const Camera& camera, const Eigen::Vector3d& position) {
  const auto pixel = Projector(camera).project(position);
  return pixel ? std::optional(QPointF(pixel->x(), pixel->y())) : std::nullopt;
}

} // namespace

CorrectionTool::CorrectionTool(const Workbench& bench, BirdsEyeView& birdsEye, QObject* parent)
    : QObject(parent), bench_(bench), birdsEye_(birdsEye) {}

void CorrectionTool::attach(int camera, CameraView* view) {
  auto* overlay = new ImagePickOverlay(view);
  overlay->setObjectName(view->objectName() + QStringLiteral("Correction"));
  overlay->setPointing(true);
  overlay->hide();
  const Layer layer{camera, view, overlay};
  layers_.push_back(layer);
  const auto name = [this, overlay, camera] {
    overlay->setHint(tr("Drag the target to where it is"));
    overlay->setAccessibleName(
        tr("Image of %1: arrow keys move a cross, Enter says that the target is there")
            .arg(bench_.cameras.nameOf(camera)));
  };
  onRetranslate(overlay, name);
  connect(&bench_.cameras, &CameraListModel::dataChanged, overlay, name);
  connect(overlay, &QObject::destroyed, this, [this, overlay] {
    std::erase_if(layers_, [overlay](const Layer& one) { return one.overlay == overlay; });
  });
  connect(overlay, &ImagePickOverlay::cancelled, this, &CorrectionTool::cancelled);
  connect(overlay, &ImagePickOverlay::chosen, this,
          [this, camera] { bench_.selection.selectCamera(camera); });
  connect(overlay, &ImagePickOverlay::grabbed, this,
          [this, layer](const QPointF& pixel) { grab(layer, pixel); });
  connect(overlay, &ImagePickOverlay::pointed, this,
          [this, camera](const QPointF& pixel) { point(camera, pixel); });
  connect(overlay, &ImagePickOverlay::picked, this,
          [this, camera](const QRectF& region) { drop(camera, region.topLeft()); });
  connect(overlay, &ImagePickOverlay::pointingEnded, this, [this] {
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

CorrectionTool::Drag CorrectionTool::held() const {
  return drag_ ? *drag_ : Drag{preferredTarget(), snapshot_};
}

std::optional<Gaussian3> CorrectionTool::estimateOf(const Drag& drag) const {
  if (!drag.snapshot || drag.target < 0 ||
      static_cast<std::size_t>(drag.target) >= drag.snapshot->targets.size()) {
    return std::nullopt;
  }
  const TrackEstimate& estimate =
      drag.snapshot->targets[static_cast<std::size_t>(drag.target)].estimate;
  // Nothing is believed yet in a frame that was not tracked.
  return particleCountOf(estimate) > 0 ? positionOf(estimate) : std::nullopt;
}

int CorrectionTool::targetAt(const Layer& layer, const QPointF& pixel) const {
  const Camera* camera = cameraOf(snapshot_, layer.camera);
  const int count = static_cast<int>(bench_.document.project().targets.size());
  int nearest = -1;
  double least = kGrabReachPx / layer.view->placement().scale;
  for (int target = 0; camera != nullptr && target < count; ++target) {
    const auto estimate = estimateOf({target, snapshot_});
    const auto there = estimate ? pixelOf(*camera, estimate->mean) : std::nullopt;
    const QPointF apart = there.value_or(QPointF()) - pixel;
    if (const double distance = std::hypot(apart.x(), apart.y()); there && distance <= least) {
      least = distance;
      nearest = target;
    }
  }
  return nearest;
}

void CorrectionTool::grab(const Layer& layer, const QPointF& pixel) {
  drag_ = Drag{-1, snapshot_};
  if (!snapshot_ || snapshot_->frame < 0) {
    return;
  }
  if (snapshot_->rerun) {
    Q_EMIT failed(tr("Frames are being tracked again: wait until that is done, or pause."));
    return;
  }
  const int pressed = targetAt(layer, pixel);
  drag_->target = pressed >= 0 ? pressed : preferredTarget();
  if (drag_->target < 0) {
    Q_EMIT failed(bench_.document.project().targets.empty()
                      ? tr("There is no target yet: learn its color first.")
                      : tr("Drag an estimate, or select the target in the list first."));
    return;
  }
  if (bench_.session.isPlaying()) {
    bench_.session.session()->pause();
  }
  bench_.selection.selectTarget(drag_->target);
}

Result<PositionCorrection> CorrectionTool::correctionOf(const Drag& drag, int camera,
                                                        const QPointF& pixel) const {
  return clickedCorrection(bench_.document.project(), *drag.snapshot->rig, drag.snapshot->frame,
                           drag.target, clickAt(camera, pixel), estimateOf(drag));
}

void CorrectionTool::point(int camera, const QPointF& pixel) {
  const Drag drag = held();
  if (!active_ || drag.target < 0 || cameraOf(drag.snapshot, camera) == nullptr) {
    return;
  }
  const PointClick click = clickAt(camera, pixel);
  const auto correction = correctionOf(drag, camera, pixel);
  const auto position =
      correction ? std::optional<Eigen::Vector3d>(correction->position) : std::nullopt;
  showGuides(correction ? correction->clicks : std::vector<PointClick>{click}, position);
  showSight(click, position);
}

bool CorrectionTool::canCorrect() const {
  return snapshot_ && snapshot_->frame >= 0 && !snapshot_->rerun && preferredTarget() >= 0;
}

void CorrectionTool::correctAt(int camera, const QPointF& pixel) {
  const Drag drag{preferredTarget(), snapshot_};
  if (!canCorrect() || cameraOf(drag.snapshot, camera) == nullptr) {
    return;
  }
  if (bench_.session.isPlaying()) {
    bench_.session.session()->pause();
  }
  bench_.selection.selectTarget(drag.target);
  deliver(drag, camera, pixel);
}

void CorrectionTool::drop(int camera, const QPointF& pixel) {
  const Drag drag = held();
  if (!active_ || drag.target < 0 || cameraOf(drag.snapshot, camera) == nullptr ||
      drag.snapshot->frame < 0 || drag.snapshot->rerun) {
    return;
  }
  deliver(drag, camera, pixel);
}

void CorrectionTool::deliver(const Drag& drag, int camera, const QPointF& pixel) {
  const auto correction = correctionOf(drag, camera, pixel);
  if (correction) {
    Q_EMIT corrected(*correction);
  } else {
    Q_EMIT failed(errorSentence(correction.error()));
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
    const Camera* camera = cameraOf(snapshot_, layer.camera);
    layer.overlay->setCrossStart(camera != nullptr && estimate ? pixelOf(*camera, estimate->mean)
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
    const Camera* camera = cameraOf(snapshot_, layer.camera);
    if (camera == nullptr) {
      continue;
    }
    std::vector<QPolygonF> lines;
    for (const PointClick& click : clicks) {
      const Camera* clicked = cameraOf(snapshot_, click.camera);
      const auto ray =
          clicked != nullptr ? Unprojector(*clicked).ray(click.pixel) : std::optional<Ray>();
      if (click.camera == layer.camera || !ray) {
        continue;
      }
      for (const ImageLine& line : projectedRay(Projector(*camera), *ray)) {
        QPolygonF& drawn = lines.emplace_back();
        for (const Eigen::Vector2d& pixel : line) {
          drawn << QPointF(pixel.x(), pixel.y());
        }
      }
    }
    layer.overlay->setGuides(std::move(lines),
                             position ? pixelOf(*camera, *position) : std::nullopt);
  }
}

void CorrectionTool::showSight(const PointClick& click,
                               const std::optional<Eigen::Vector3d>& position) {
  const Camera* camera = cameraOf(snapshot_, click.camera);
  const auto ray = camera != nullptr ? Unprojector(*camera).ray(click.pixel) : std::optional<Ray>();
  if (!ray || !position) {
    birdsEye_.showSight({});
    return;
  }
  const double length = kBeyond * (*position - ray->origin).norm();
  birdsEye_.showSight({ray->origin, ray->origin + length * ray->direction});
}

void CorrectionTool::clearGuides() {
  for (const Layer& layer : layers_) {
    layer.overlay->setGuides({}, std::nullopt);
  }
  birdsEye_.showSight({});
}

} // namespace dewpoint::ui
